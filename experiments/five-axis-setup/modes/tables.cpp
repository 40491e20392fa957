// SPDX-License-Identifier: GPL-3.0-or-later
#include "five-axis-setup/modes/tables.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

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

constexpr double margin = 1e-8;  // rad, above the rounding of ranges

PoseSearchResult search_over_cells(const StudiedPart& part, RotaryFamily family,
                                   SetupMode mode, const RotaryLimits& limits = {})
{
    return pose_search(part.visibility.map, part.grid.centres,
                       {.family = family, .mode = mode, .limits = limits});
}

// The objective at the pose of least area, in degrees or square degrees.
CsvCell at_least_area(const PoseMeasure& measure, const PoseSearchResult& found)
{
    if (!found.least)
        return std::monostate{};
    return in_degrees(measure.objective,
                      measure(pose_ranges(measure.family, *found.least)));
}

// The ranges of which the paper requires at least those of the least area: both ends of
// phi, and the width of C (C,A) or both ends of theta.
std::vector<double> required_ranges(RotaryFamily family, const FittedPose& fit)
{
    const auto phi = magnitudes(fit.phi);
    const auto theta = magnitudes(fit.theta);
    if (family == RotaryFamily::CA)
        return {phi[0], phi[1], fit.theta.to - fit.theta.from};
    return {phi[0], phi[1], theta[0], theta[1]};
}

// The number of ranges of `fit` that are smaller than those of `least`.
std::size_t ranges_below(RotaryFamily family, const FittedPose& fit,
                         const FittedPose& least)
{
    const auto needed = required_ranges(family, fit);
    const auto required = required_ranges(family, least);
    std::size_t below = 0;
    for (std::size_t k = 0; k < needed.size(); ++k)
        below += needed[k] < required[k] - margin ? 1 : 0;
    return below;
}

// The mode `paper` compared with the pose `best` over whole cones, whose objective is
// `value`.
NamedCells comparison_cells(const StudiedPart& part, const PoseMeasure& measure,
                            const FittedPose& best, double value)
{
    const PoseSearchResult paper =
        search_over_cells(part, measure.family, SetupMode::Paper);
    const PoseSearchResult on_machine =
        search_over_cells(part, measure.family, SetupMode::Paper, {best.phi, best.theta});
    NamedCells cells{{"paper", at_least_area(measure, paper)},
                     {"paper_on_that_machine", word(on_machine.feasible.has_value())}};
    if (!paper.least)
        return cells;
    const double at_paper = measure(pose_ranges(measure.family, *paper.least));
    return joined(cells, {{"paper_over_set", at_paper / value},
                          {"ranges_below_mar",
                           count(ranges_below(measure.family, best, *paper.least))}});
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
    return {"paper",
            "corrected",
            "set",
            "lower_bound",
            "gap_percent",
            "width_deg",
            "m0_deg",
            "m1_deg",
            "area_deg2",
            "r1_x",
            "r1_y",
            "r1_z",
            "tilt_deg",
            "azimuth_deg",
            "axis_x",
            "axis_y",
            "axis_z",
            "leans_to_x",
            "nodes",
            "unresolved",
            "paper_over_set",
            "ranges_below_mar",
            "paper_on_that_machine"};
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
        {"corrected", at_least_area(measure, search_over_cells(part, measure.family,
                                                               SetupMode::Corrected))},
        {"set", in_degrees(measure.objective, value)},
        {"lower_bound", in_degrees(measure.objective, bound)},
        {"gap_percent", 100 * (value / bound - 1)},
        {"nodes", count(best.poses_tried)},
        {"unresolved", count(best.certificate->unresolved)}};
    const FittedPose& fit = best.feasible.value();
    return joined(
        joined(comparison_cells(part, measure, fit, value), values),
        joined(pose_cells(measure.family, fit), axis_cells(fit.pose.tool_axis)));
}

}  // namespace endmill
