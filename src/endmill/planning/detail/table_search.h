// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "endmill/planning/detail/bounded_search.h"
#include "endmill/planning/detail/curve_search.h"
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
    CurveSearch curves;      ///< of the first stage
    int scored = 1000;       ///< best pairs of curves, judged by all runs
    int fitted = 6;          ///< best of these, fitted in a box
    int refined = 2;         ///< best of these, refined in smaller boxes
    int evaluations = 3000;  ///< of surfaces, in each box
    std::uint32_t seed = 1;  ///< of the searches in boxes
};

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
