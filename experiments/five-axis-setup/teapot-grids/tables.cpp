// SPDX-License-Identifier: GPL-3.0-or-later
#include "five-axis-setup/teapot-grids/tables.h"

#include <cmath>
#include <cstdint>

#include "endmill/setup/detail/rectangle_candidate.h"
#include "endmill/setup/pose_search.h"
#include "support/setup_cells.h"

namespace endmill {
namespace {

double true_area(const StudiedPart& part, const FittedPose& fit)
{
    return rectangle_about(fit.pose.tool_axis, fit.pose.r1_axis,
                           nearest_directions(part, fit))
        .area();
}

NamedCells name_cells(const StudiedPart& part, const NamedSearch& search)
{
    return {{"grid", part.grid.name}, {"family", search.family}, {"mode", search.mode}};
}

}  // namespace

PoseSearchResult NamedSearch::operator()(const StudiedPart& part) const
{
    return pose_search(part.visibility.map, part.grid.centres,
                       {family_of_word(family), mode_of_word(mode)});
}

std::vector<NamedSearch> named_searches(const std::vector<std::string>& families,
                                        const std::vector<std::string>& modes)
{
    std::vector<NamedSearch> searches;
    for (const std::string& family : families)
        for (const std::string& mode : modes)
            searches.push_back({family, mode});
    return searches;
}

std::vector<std::string> search_columns()
{
    return {"grid",       "family",       "mode",        "area_deg2",   "true_area_deg2",
            "phi_s_deg",  "phi_l_deg",    "theta_s_deg", "theta_l_deg", "width_deg",
            "tilt_deg",   "azimuth_deg",  "axis_x",      "axis_y",      "axis_z",
            "leans_to_x", "poses_skipped"};
}

NamedCells search_cells(const StudiedPart& part, const NamedSearch& search)
{
    const PoseSearchResult found = search(part);
    NamedCells cells = name_cells(part, search);
    cells.emplace_back("poses_skipped", static_cast<std::int64_t>(found.poses_skipped));
    if (!found.least)
        return cells;
    const RotaryFamily family = family_of_word(search.family);
    cells = joined(cells, range_cells(family, *found.least));
    cells = joined(cells, axis_cells(found.least->pose.tool_axis));
    if (family == RotaryFamily::AB)
        cells.emplace_back("true_area_deg2",
                           square_degrees(true_area(part, *found.least)));
    return cells;
}

NamedCells moved_cells(const StudiedPart& part, const StudiedPart& moved_part,
                       const NamedSearch& search)
{
    const double before = search(part).least.value().area;
    const double after = search(moved_part).least.value().area;
    return joined(name_cells(part, search),
                  {{"area_deg2", square_degrees(after)},
                   {"change_relative", std::abs(after - before) / before}});
}

}  // namespace endmill
