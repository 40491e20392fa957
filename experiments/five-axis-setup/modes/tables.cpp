// SPDX-License-Identifier: GPL-3.0-or-later
#include "five-axis-setup/modes/tables.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "endmill/core/angle.h"
#include "endmill/setup/pose_search.h"
#include "endmill/setup/setup.h"
#include "support/setup_cells.h"

namespace endmill {
namespace {

CsvCell count(std::size_t number)
{
    return static_cast<std::int64_t>(number);
}

CsvCell at_pose_of(const StudiedPart& part, const PoseMeasure& measure, SetupMode mode)
{
    const PoseSearchResult found =
        pose_search(part.visibility.map, part.grid.centres, {measure.family, mode});
    if (!found.least)
        return std::monostate{};
    return in_degrees(measure.objective,
                      measure(pose_ranges(measure.family, *found.least)));
}

NamedCells pose_cells(RotaryFamily family, const FittedPose& fit)
{
    const PoseRanges ranges = pose_ranges(family, fit);
    const auto degrees = [](double angle) { return Angle::radians(angle).degrees(); };
    const Vec3& r1 = fit.pose.r1_axis;
    return {{"width_deg", degrees(ranges.width)},
            {"m0_deg", degrees(std::max(ranges.m0, ranges.m1))},
            {"m1_deg", degrees(std::min(ranges.m0, ranges.m1))},
            {"area_deg2", square_degrees(fit.area)},
            {"r1_x", r1.x()},
            {"r1_y", r1.y()},
            {"r1_z", r1.z()}};
}

}  // namespace

std::vector<std::string> mode_columns()
{
    return {"paper",     "corrected", "set",        "lower_bound", "gap_percent",
            "width_deg", "m0_deg",    "m1_deg",     "area_deg2",   "r1_x",
            "r1_y",      "r1_z",      "tilt_deg",   "azimuth_deg", "axis_x",
            "axis_y",    "axis_z",    "leans_to_x", "nodes",       "unresolved"};
}

NamedCells mode_cells(const StudiedPart& part, const WholeConeSearch& search)
{
    const PoseMeasure measure{.family = family_of_word(search.family),
                              .objective = objective_of_word(search.objective)};
    const PartSetup best = five_axis_setup(
        part.grid, part.visibility.map,
        {.reach = {.configuration = configuration_of_family(measure.family)},
         .mode = SetupMode::WholeCones,
         .whole_cones = {.objective = measure.objective, .gap = search.gap}});
    const double value = best.objective.value();
    const double bound = best.certificate.value().lower_bound;
    const NamedCells values{
        {"paper", at_pose_of(part, measure, SetupMode::Paper)},
        {"corrected", at_pose_of(part, measure, SetupMode::Corrected)},
        {"set", in_degrees(measure.objective, value)},
        {"lower_bound", in_degrees(measure.objective, bound)},
        {"gap_percent", 100 * (value / bound - 1)},
        {"nodes", count(best.poses_tried)},
        {"unresolved", count(best.certificate->unresolved)}};
    const FittedPose& fit = best.feasible.value();
    return joined(
        values, joined(pose_cells(measure.family, fit), axis_cells(fit.pose.tool_axis)));
}

}  // namespace endmill
