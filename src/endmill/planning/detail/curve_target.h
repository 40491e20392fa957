// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "endmill/planning/detail/composite_curve.h"

/// \file
/// The first target of the search for the lost surface: one curve that, marched forward and backward
/// with the three chord tolerances of the tables, has given numbers of points and given lengths.

namespace endmill {

/// Numbers of points and chord lengths of the passes for one tolerance.
struct PassPair {
    int points_a_pair;                  ///< f + b
    std::optional<int> points_forward;  ///< f, if known
    double chord_mm;            ///< mean length of the forward and the backward pass
    double chord_tolerance_mm;  ///< accepted deviation of `chord_mm`
};

/// What one curve has to fulfil: one pair for each tolerance of the tables.
using CurveTarget = std::array<PassPair, 3>;

/// What a curve has.
struct CurveMarch {
    int points_forward;     ///< f
    int points_backward;    ///< b
    double steps_forward;   ///< steps, the last one as a share, see MarchedCurve
    double steps_backward;  ///< the same for the backward pass
    double forward_mm;      ///< sum of the chords of the forward pass
    double backward_mm;     ///< the same for the backward pass
};

/// Marches `curve` by its own curvature with the three tolerances of the tables.
/// \return nothing if a step makes no progress.
std::optional<std::array<CurveMarch, 3>> march_both_ways(const CompositeCurve& curve);

/// Whether no step cuts off a bend, so that the passes are like those of the decoded print: for each tolerance
/// the forward and the backward pass differ by at most 2 points and 1 % of the length, and their mean length is at
/// least 98.5 % of that for the smallest tolerance.
/// Source: experiments/economic-cl-data/lost-surface/criterion.md, amendment 1.
bool has_regular_passes(const std::array<CurveMarch, 3>& march);

/// Steps that are missing or too many for `points` points, counted with the share of the last step: 0 if
/// the pass has that number of points and its last step is at least 0.001 of a step.
double missing_steps(double steps, int points);

/// Distance of `march` from `target`: zero exactly if all numbers are equal and all lengths within
/// their tolerance, or a last step is within 0.001 steps of it. Squares of the missing steps, with weight
/// 4, and of the missing millimetres.
double curve_loss(const std::array<CurveMarch, 3>& march, const CurveTarget& target);

/// The same, marched one tolerance after the other, those with few points first, and given up as soon as the
/// loss exceeds `give_up`. Infinite if a step makes no progress.
double curve_loss(const CompositeCurve& curve, const CurveTarget& target, double give_up);

/// Number of the up to nine numbers of `target` that `march` has: f and b, or their sum twice if f is
/// not known, and the length.
int curve_matches(const std::array<CurveMarch, 3>& march, const CurveTarget& target);

/// Integrals along a curve by which counts and lengths scale for small tolerances: a pass has about
/// integral of sqrt(k) / sqrt(8 delta) steps, and its chords are shorter than the arc by delta / 3 times
/// the turning if every chord has the error delta.
struct CurveIntegrals {
    double arc_mm;          ///< length
    double turning;         ///< integral of the curvature k over the length, rad
    double root_curvature;  ///< integral of sqrt(k), sqrt(mm)
};

/// The integrals by Simpson's rule with 200 intervals a piece: relative error below 1e-3 unless the
/// curvature nearly vanishes or a piece nearly has a cusp.
CurveIntegrals curve_integrals(const CompositeCurve& curve);

}  // namespace endmill
