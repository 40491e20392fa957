// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/deviation/detail/cut_ray.h"
#include "endmill/deviation/deviation.h"
#include "endmill/stock/detail/tool_pieces.h"

namespace endmill {

/// The material before a path whose axis may turn, and its motions.
struct TurnedStock {
    const ToolPieces& pieces;  ///< all motions; the region holds all rays
    InitialRay initial_ray;    ///< must be set; finite thickness for every ray
};

/// The deviation after a path whose axis may turn.
struct TurningDeviation {
    Deviation deviation;
    /// Lower bound of the distance in mm between cutters and part; infinity without moves.
    double gap_mm;
};

/// Measures the deviation on rays along the part's normals, as `measure_deviation` does,
/// for motions whose axis may turn. Every ray has a lower and an upper bound of its
/// thickness. The greatest remaining stock is the greatest lower bound, the deepest gouge
/// the least upper bound, so both are certain; the error bounds hold for the other bound
/// and between the rays. `Deviation::left` has the middle of the bounds.
///
/// Where the bounds could change the verdict, the motions are halved and the
/// cells are divided. A sweep number in the result is the number of the path point to
/// which the move leads.
///
/// The result is the same with any number of threads, and for any order of the pieces
/// within the bounds.
/// Source: docs/methods/five-axis-removal.md, sections 3 and 4.
/// \throws DomainError for options out of range or without an initial ray.
/// \throws LimitError if there are more cells than `most_cells`.
TurningDeviation measure_turning_deviation(const PartCharts& charts,
                                           const TurnedStock& stock,
                                           const DeviationOptions& options);

}  // namespace endmill
