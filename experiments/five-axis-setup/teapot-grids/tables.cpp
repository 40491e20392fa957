// SPDX-License-Identifier: GPL-3.0-or-later
#include "five-axis-setup/teapot-grids/tables.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "endmill/core/error.h"
#include "endmill/setup/detail/rectangle_candidate.h"
#include "endmill/setup/pose_search.h"
#include "support/setup_cells.h"

namespace endmill {
namespace {

// Whether the pot leans to its spout when the tool axis points upwards: then the axis
// leans the other way in the part's frame.
CsvCell pot_lean(const Vec3& tool_axis)
{
    for (const auto& [name, cell] : axis_cells(-tool_axis))
        if (name == "leans_to_x")
            return cell;
    return std::monostate{};
}

NamedCells name_cells(const StudiedPart& part, const NamedSearch& search)
{
    return {{"grid", part.grid.name}, {"family", search.family}, {"mode", search.mode}};
}

}  // namespace

double true_area(const StudiedPart& part, const FittedPose& fit)
{
    return rectangle_about(fit.pose.tool_axis, fit.pose.r1_axis,
                           nearest_directions(part, fit))
        .area();
}

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
    return {"grid",
            "family",
            "mode",
            "area_deg2",
            "true_area_deg2",
            "phi_s_deg",
            "phi_l_deg",
            "theta_s_deg",
            "theta_l_deg",
            "width_deg",
            "tilt_deg",
            "azimuth_deg",
            "axis_x",
            "axis_y",
            "axis_z",
            "leans_to_x",
            "pot_leans_to_spout",
            "poses_skipped",
            "over_corrected",
            "true_over_claimed"};
}

std::vector<FoundSetup> found_setups(const StudiedPart& part,
                                     const std::vector<NamedSearch>& searches)
{
    std::vector<FoundSetup> setups;
    for (const NamedSearch& search : searches)
        setups.push_back({search, search(part)});
    return setups;
}

const PoseSearchResult& result_of(const std::vector<FoundSetup>& setups,
                                  const std::string& family, const std::string& mode)
{
    const auto found = std::ranges::find_if(setups, [&](const FoundSetup& setup) {
        return setup.search.family == family && setup.search.mode == mode;
    });
    require(found != setups.end(), "result_of: need one of the searches");
    return found->found;
}

NamedCells search_cells(const StudiedPart& part, const std::vector<FoundSetup>& setups,
                        const FoundSetup& shown)
{
    const NamedSearch& search = shown.search;
    const PoseSearchResult& found = shown.found;
    NamedCells cells = name_cells(part, search);
    cells.emplace_back("poses_skipped", static_cast<std::int64_t>(found.poses_skipped));
    if (!found.least)
        return cells;
    const RotaryFamily family = family_of_word(search.family);
    const double area = found.least->area;
    cells = joined(cells, range_cells(family, *found.least));
    cells = joined(cells, axis_cells(found.least->pose.tool_axis));
    cells.emplace_back("pot_leans_to_spout", pot_lean(found.least->pose.tool_axis));
    const auto& corrected = result_of(setups, search.family, "corrected").least;
    cells.emplace_back("over_corrected", area / corrected.value().area);
    if (family == RotaryFamily::AB) {
        const double needed = true_area(part, *found.least);
        cells.emplace_back("true_area_deg2", square_degrees(needed));
        cells.emplace_back("true_over_claimed", needed / area);
    }
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
