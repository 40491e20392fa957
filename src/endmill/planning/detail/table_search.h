// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "endmill/planning/detail/bounded_search.h"
#include "endmill/planning/detail/curve_target.h"
#include "endmill/planning/detail/surface_families.h"
#include "endmill/planning/detail/table_match.h"

/// \file
/// Searches for a surface of a family whose 18 runs have given cells.

namespace endmill {

/// A surface of a family with its ratio of scallop height to chord tolerance.
struct TableFit {
    std::vector<double> values;  ///< of the family, then the ratio h / delta
    double loss;                 ///< see table_loss
    int evaluations;             ///< of surfaces
};

/// The ranges of a fit: value_ranges of the family, then 0.3 to 1.1 for h / delta.
std::vector<Interval> fit_ranges(SurfaceFamily family);

/// The cells of a fit. \return nothing if a run does not exist.
/// \param values   as TableFit::values.
/// \param policies with any `scallop_per_tolerance`.
std::optional<EconomyTables> fitted_tables(SurfaceFamily family, RunPolicies policies,
                                           std::span<const double> values);

/// Loss of a fit: the deviation_bits of all cells, and 2 e^2 for a deviation of e percent, which leads
/// the search from afar. Gives up beyond `give_up`; infinite if a run does not exist.
double table_loss(SurfaceFamily family, RunPolicies policies, const EconomyTables& target,
                  std::span<const double> values, double give_up);

/// The search that is given the cells only: `minimise` of table_loss.
TableFit search_cells(SurfaceFamily family, const RunPolicies& policies,
                      const EconomyTables& target, const BoundedSearch& search);

/// Whole numbers that an interpretation by `decodings` assigns to a table, or those of a known surface.
struct DecodedTables {
    /// Points and lengths of the passes along u and v.
    std::array<CurveTarget, 2> passes;
    /// Numbers of passes; 0 for runs that are left out. Indices: direction, tolerance, diameter.
    std::array<std::array<std::array<int, 3>, 3>, 2> counts;
};

/// Effort of the staged search.
struct StagedSearch {
    int curves = 150;              ///< wanted for each of A and B
    int curve_searches = 1500;     ///< most searches for them
    int curve_evaluations = 3000;  ///< of each of them
    /// Loss with which a curve is taken, see curve_loss: 0 if it has to have all its numbers, more if the fit of the
    /// pairs may correct the rest.
    double accepted_curve_loss = 0.5;
    int scored = 1000;         ///< best pairs of curves, judged by all runs
    int fitted = 6;            ///< best of these, fitted in a box
    int refined = 2;           ///< best of these, refined in smaller boxes
    int evaluations = 3000;    ///< of surfaces, in each box
    double most_height = 360;  ///< of a curve, mm; higher ones are penalised
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
/// \return the values of those found, at most `search.curves`; see family_curve.
std::vector<std::vector<double>> search_curves(SurfaceFamily family, int curve,
                                               const CurveTarget& target,
                                               const StagedSearch& search);

/// Whether a curve could be one of the print: with regular passes, no higher than `most_height` mm, and not so
/// concave that even seen across steep passes the balls would not fit.
bool is_plausible(const CompositeCurve& curve, double most_height);

/// Difference of the highest and the lowest point of 31 a piece, mm.
double height_of(const CompositeCurve& curve);

/// Largest curvature towards +z, seen across the curve, at 31 points a piece, 1/mm; 0 for a convex curve.
/// A translational surface is at most as concave along the curve.
double concavity_of(const CompositeCurve& curve);

/// Result of the staged search.
struct StagedFit {
    std::array<int, 2> curves_found;  ///< curves along u and v that were taken
    /// Root mean square of the passes with 1 mm that the best pair misses, in percent.
    double passes_percent;
    TableFit best;  ///< values empty if one of the curves was not found
};

/// The search for a translational surface in stages:
/// 1. curves A and B that have the points and the lengths of `decoded` by themselves;
/// 2. all pairs of them with a ratio h / delta, ordered by the passes with 1 mm that they miss, and
///    the best of these by structure_loss;
/// 3. `minimise` of structure_loss in boxes about the best pairs, smaller ones for the best fits, and
/// 4. `minimise` of table_loss in boxes of 0.2 %.
/// \pre the family is Translational, Uneven or Skew, and steps follow the curvature of the curve
StagedFit search_in_stages(SurfaceFamily family, const RunPolicies& policies,
                           const EconomyTables& target, const DecodedTables& decoded,
                           const StagedSearch& search);

}  // namespace endmill
