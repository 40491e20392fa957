// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/deviation/detail/cut_ray.h"
#include "endmill/deviation/detail/part_cell.h"

namespace endmill {

/// A cell of the part with what is left at its middle.
struct MeasuredCell {
    PartCell cell;
    PartRay ray;            ///< at its middle
    double reach;           ///< from there to its furthest corner, mm
    MownRay left;           ///< at its middle
    PartCharts::Bend bend;  ///< of the part nearby
    bool is_outer = false;  ///< on an outer wall of the part, whose rest is not judged
    std::optional<double> nearer = {};  ///< what counts instead of `left`, mm
    bool is_measured = true;            ///< else `nearer` is a close bound of what counts
    double area = 0;                    ///< mm^2
    MownRay in_stock = {};              ///< of its middle's ray, before any move

    /// What counts at its middle, in mm.
    double value() const
    {
        const double along = nearer.value_or(left.left);
        return is_outer ? std::min(along, 0.0) : along;
    }
};

/// How much deeper than at its middle a gouge may be anywhere on the cell, in mm: the
/// height of a circle of the corner's and the part's curvature above its tangent.
/// \pre the corner is round, and the part goes on smoothly beyond the cell: the deepest
/// place of a sweep is then one where its depth is stationary.
double hidden_gouge(const MeasuredCell& cell, const Cutter& cutter);

/// A bound in mm, at most 0, below which nothing is left anywhere on the cell, for any cutter and at
/// creases too: of each of `sweeps` by planes beyond which it stays. Minus infinity where
/// a sweep clears the part and no plane tells how deep.
/// \param sweeps all that may clear the part within the cell's reach, at least.
double least_left_by_planes(const MeasuredCell& cell, std::span<const StraightSweep> all,
                            std::span<const std::int32_t> sweeps);

/// Those of `sweeps` that no plane keeps off the part on the cell.
std::vector<std::int32_t> sweeps_on_cell(const MeasuredCell& cell,
                                         std::span<const StraightSweep> all,
                                         std::span<const std::int32_t> sweeps);

/// A bound in mm on what is left anywhere on the cell, by the slope of what is left at its
/// middle and the curvatures of the cutter's corner and the part. Infinite for a sharp
/// edge.
double most_left_by_slope(const MeasuredCell& cell, const Cutter& cutter);

/// How much more than at a cell's middle a sweep may leave there and still leave least
/// somewhere on the cell, in mm: its reach times the slopes of both, with some to spare.
double owner_margin(const MeasuredCell& cell);

/// Those of `sweeps` that leave less than the owner's margin more at the cell's middle
/// than what is left there, the lowest first.
std::vector<std::int32_t> local_sweeps(const MeasuredCell& cell,
                                       std::span<const StraightSweep> all,
                                       std::span<const std::int32_t> sweeps);

/// A bound as most_left_by_slope, by what single sweeps leave at the cell's corners: the
/// least over one of the first few of `sweeps` alone, and over any mean of two. Infinite
/// where the part has no normal at a corner, or none of them clears all corners nearly.
double most_left_by_corners(const MeasuredCell& cell, const PartCharts& charts,
                            std::span<const StraightSweep> all,
                            std::span<const std::int32_t> sweeps);

}  // namespace endmill
