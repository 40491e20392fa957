// SPDX-License-Identifier: GPL-3.0-or-later
#include "five-axis-setup/teapot-grids/comparisons.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <Eigen/Geometry>

#include "endmill/setup/pose_search.h"
#include "support/setup_cells.h"

namespace endmill {
namespace {

double degrees(double angle)
{
    return Angle::radians(angle).degrees();
}

const FittedPose& best(const GridSetups& grid, const std::string& family,
                       const std::string& mode = "paper")
{
    return result_of(grid.setups, family, mode).least.value();
}

double apart(const Vec3& a, const Vec3& b)
{
    return std::min(angle_between(a, b), angle_between(a, {b.x(), -b.y(), b.z()}));
}

RotaryRange range(const std::vector<double>& ends_deg)
{
    return {Angle::degrees(ends_deg.at(0)).radians(),
            Angle::degrees(ends_deg.at(1)).radians()};
}

}  // namespace

std::vector<std::string> comparison_columns()
{
    return {"least_tilt_deg",       "largest_tilt_deg",        "grids_lean_to_x",
            "worst_over_corrected", "worst_true_over_claimed", "axes_apart_deg",
            "grids_that_agree",     "poses_feasible",          "poses",
            "setup_decides"};
}

NamedCells spread_cells(const std::vector<GridSetups>& grids, const std::string& family,
                        const std::string& mode)
{
    double least = std::numeric_limits<double>::infinity();
    double largest = 0;
    double over_corrected = 0;
    double over_claimed = 0;
    std::int64_t leaning = 0;
    for (const GridSetups& grid : grids) {
        const FittedPose& fit = best(grid, family, mode);
        const double tilt = angle_between(fit.pose.tool_axis, Vec3::UnitZ());
        least = std::min(least, tilt);
        largest = std::max(largest, tilt);
        leaning += fit.pose.tool_axis.x() > 0 ? 1 : 0;
        over_corrected =
            std::max(over_corrected, fit.area / best(grid, family, "corrected").area);
        if (family == "AB")
            over_claimed = std::max(over_claimed, true_area(grid.part, fit) / fit.area);
    }
    const NamedCells cells{{"least_tilt_deg", degrees(least)},
                           {"largest_tilt_deg", degrees(largest)},
                           {"grids_lean_to_x", leaning},
                           {"worst_over_corrected", over_corrected}};
    if (family != "AB")
        return cells;
    return joined(cells, {{"worst_true_over_claimed", over_claimed}});
}

NamedCells agreement_cells(const std::vector<GridSetups>& grids,
                           const std::string& family, std::size_t cells)
{
    std::vector<const GridSetups*> equal;
    for (const GridSetups& grid : grids)
        if (grid.part.grid.cells.size() == cells)
            equal.push_back(&grid);
    const FittedPose& first = best(*equal.at(0), family);
    double farthest = 0;
    std::int64_t agreeing = 0;
    for (const GridSetups* one : equal) {
        for (const GridSetups* other : equal)
            farthest = std::max(farthest, apart(best(*one, family).pose.tool_axis,
                                                best(*other, family).pose.tool_axis));
        const PoseSearchResult found =
            pose_search(one->part.visibility.map, one->part.grid.centres,
                        {.family = family_of_word(family),
                         .mode = SetupMode::Paper,
                         .limits = {first.phi, first.theta}});
        agreeing += found.feasible ? 1 : 0;
    }
    return {{"axes_apart_deg", degrees(farthest)}, {"grids_that_agree", agreeing}};
}

NamedCells machine_cells(const StudiedPart& part, const std::vector<double>& r1_deg,
                         const std::vector<double>& r2_deg)
{
    const PoseFitOptions options{.family = RotaryFamily::AB,
                                 .mode = SetupMode::Paper,
                                 .limits = {range(r1_deg), range(r2_deg)}};
    std::int64_t feasible = 0;
    for (std::size_t cell = 0; cell < part.grid.centres.size(); ++cell) {
        FittedPose at_cell{};
        at_cell.cell = cell;
        const auto found =
            pose_fit(part.grid.centres[cell], nearest_directions(part, at_cell), options);
        feasible += found.feasible ? 1 : 0;
    }
    const std::int64_t poses = std::ssize(part.grid.centres);
    return {{"poses_feasible", feasible},
            {"poses", poses},
            {"setup_decides", word(feasible > 0 && feasible < poses)}};
}

}  // namespace endmill
