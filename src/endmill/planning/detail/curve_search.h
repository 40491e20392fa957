// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "endmill/planning/detail/curve_target.h"
#include "endmill/planning/detail/surface_families.h"

/// \file
/// The first stage of the search for the lost surface: curves A(u) or B(v) of a family whose passes have given points
/// and lengths. A curve has fewer values than a surface and is marched 100 times faster.

namespace endmill {

/// Effort of a search for curves.
struct CurveSearch {
    int wanted = 150;        ///< number of curves
    int searches = 1500;     ///< most searches for them
    int evaluations = 3000;  ///< of each search
    /// Loss with which a curve is taken, see curve_loss: 0 if it has to have all its numbers, more if a later fit
    /// may correct the rest.
    double accepted_loss = 0.5;
    double most_height = 360;  ///< mm; higher curves are penalised
    std::uint32_t seed = 1;    ///< of the random curves, and first of the searches
};

/// Values of the family that belong to its curve A (0) or B (1), in their order.
/// \pre the family is Translational, Uneven or Skew
std::vector<std::size_t> curve_positions(SurfaceFamily family, int curve);

/// The curve A (0) or B (1) with these of the values, see curve_positions.
CompositeCurve family_curve(SurfaceFamily family, int curve,
                            std::span<const double> values);

/// The first stage: searches for curves that have the points and the lengths of `target` by themselves,
/// each in a box about a random plausible curve.
/// \return the values of those found, at most `search.wanted`; see family_curve.
std::vector<std::vector<double>> search_curves(SurfaceFamily family, int curve,
                                               const CurveTarget& target,
                                               const CurveSearch& search);

/// Whether a curve could be one of the print: with regular passes, no higher than `most_height` mm, and not so
/// concave that even seen across steep passes the balls would not fit.
bool is_plausible(const CompositeCurve& curve, double most_height);

/// Difference of the highest and the lowest point of 31 a piece, mm.
double height_of(const CompositeCurve& curve);

/// Largest curvature towards +z, seen across the curve, at 31 points a piece, 1/mm; 0 for a convex curve.
/// A translational surface is at most as concave along the curve.
double concavity_of(const CompositeCurve& curve);

}  // namespace endmill
