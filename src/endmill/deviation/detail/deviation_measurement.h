// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "endmill/cutter/straight_sweep.h"
#include "endmill/deviation/detail/cut_ray.h"
#include "endmill/deviation/deviation.h"

namespace endmill {

/// The material before the path, and all moves through it.
struct MachinedStock {
    /// Of all runs, in order; the path's own last.
    std::span<const StraightSweep> sweeps;
    std::size_t earlier_sweeps = 0;  ///< number of sweeps of earlier runs
    InitialRay initial_ray;          ///< must be set; finite thickness for every ray
    /// Greatest gouge and greatest remaining stock that a proof allows; none without a
    /// proof.
    std::optional<DeviationLimits> proved = {};
};

/// Measures the deviation of the machined stock from the part on rays along the part's
/// normals. There is a ray at the middle of every cell of `pitch`. Cells are refined
/// where the surface between two rays could change the verdict, or a maximum by more than
/// the slack and a twentieth (gouge: a quarter) of its limit.
///
/// *Which part of a ray counts.* Beside a wall, in a corner or on a narrow ridge, the ray
/// of one face may end near another face. So a thickness, or a depth, counts only up to
/// the radius of the largest ball that touches the part at the ray's point and contains
/// no other place of the part. This holds for every ray whatever the limits. The two
/// maxima are measured exactly in this way, other rays to about 1 % where that is much
/// faster.
///
/// *What is refined.* Once a gouge beyond the tolerance is known, nothing is refined.
/// Once too much material is known to remain, only possible gouges are refined. Both
/// areas are sums over the finest cells. Where a proof of the stock excludes a change of
/// the verdict or a maximum, nothing is refined for it. If no ray meets a move, the cells that a move
/// comes near are halved until a ray does.
///
/// *Bounds.* Between the rays on a smooth piece of the part a round corner hides a gouge
/// of at most (d^2 / 2)(1 / r + k), with d half the diagonal of a cell, r the cutter's
/// corner radius and k the part's convex curvature. Where this does not hold (a sharp
/// edge, a crease or side of a patch or triangle, a cell that is not small against r), a
/// separating plane bounds the depth of every sweep near the cell. The shape of the part
/// and of the sweeps bounds the remaining stock. Above a flat piece of the part, the
/// stock that one sweep leaves is a convex function of the place. Its maximum therefore
/// lies at a corner of the cell. The part's curvature k adds d^2 k.
///
/// *What is not judged.* In refined cells, a strip of half a first cell along the border
/// of the part (sides of surfaces that meet no other side, edges of one triangle) counts
/// as neither gouge nor remaining stock. It enters the bounds, because a finer grid would
/// judge it. Remaining stock is not judged on upright outer walls, beside which there is
/// no part within half a pitch: no path over the part reaches the stock there. Such cells
/// count as 0 and have no area. The same holds where DeviationOptions::is_accessible
/// returns false for the middle of a cell.
///
/// The result is the same with any number of threads.
/// Source: docs/methods/removal.md, section 2 and section 3; the bounds are derived
/// in paper/notes/deviation-bounds.md.
/// \throws DomainError for options out of range or without an initial ray.
/// \throws LimitError if there are more cells than `most_cells`.
Deviation measure_deviation(const PartCharts& charts, const MachinedStock& stock,
                            const DeviationOptions& options);

}  // namespace endmill
