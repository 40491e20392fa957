// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to simulation
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/simulation/mown_rays.h"
#include "endmill/simulation/part_cell.h"

namespace endmill {

/// A cell of the part with what is left at its middle.
struct MeasuredCell {
    PartCell cell;
    PartRay ray;            ///< at its middle
    double reach;           ///< from there to its furthest corner, mm
    MownRay left;           ///< at its middle
    PartCharts::Bend bend;  ///< of the part nearby
};

/// How much deeper than at its middle a gouge may be anywhere on the cell, in mm.
double hidden_gouge(const MeasuredCell& cell, const Cutter& cutter);

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
