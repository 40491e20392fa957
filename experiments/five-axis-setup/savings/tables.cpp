// SPDX-License-Identifier: GPL-3.0-or-later
#include "five-axis-setup/savings/tables.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "endmill/setup/detail/arc_search.h"
#include "endmill/setup/detail/sector_fit.h"
#include "endmill/setup/pose_search.h"
#include "endmill/visibility/visibility.h"
#include "support/setup_cells.h"

namespace endmill {
namespace {

std::size_t accessible_entries(const VisibilityMap& map)
{
    std::size_t entries = 0;
    for (std::size_t cell = 0; cell < map.cells(); ++cell)
        for (const std::uint64_t word : map.column(cell))
            entries += static_cast<std::size_t>(std::popcount(word));
    return entries;
}

CsvCell count(std::size_t number)
{
    return static_cast<std::int64_t>(number);
}

}  // namespace

SetupSavings setup_savings(const StudiedPart& part)
{
    const auto cells = static_cast<double>(part.visibility.map.cells());
    const auto facets = static_cast<double>(part.visibility.map.facets());
    const double group_1 =
        static_cast<double>(accessible_entries(part.visibility.map)) / cells;
    double nearest = 0;
    for (std::size_t cell = 0; cell < part.visibility.map.cells(); ++cell)
        nearest += static_cast<double>(
            nearest_cells(part.visibility.map, part.grid.centres, cell).size());
    return {100 * group_1 / facets, facets - group_1, nearest / cells};
}

NamedCells cone_cells(const StudiedPart& part)
{
    return {{"facets", count(part.visibility.map.facets())},
            {"empty_cones", count(empty_cones(part.visibility).size())},
            {"accessible_entries", count(accessible_entries(part.visibility.map))}};
}

NamedCells blocked_cells(const StudiedPart& part, const StudiedPart& local)
{
    const auto left = static_cast<double>(accessible_entries(part.visibility.map));
    const auto all = static_cast<double>(accessible_entries(local.visibility.map));
    return {{"blocked_percent", 100 * (1 - left / all)}};
}

NamedCells group_1_cells(const StudiedPart& part)
{
    const PoseSearchResult search =
        pose_search(part.visibility.map, part.grid.centres, {});
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t cell = 0; cell < part.grid.centres.size(); ++cell) {
        FittedPose at_cell{};
        at_cell.cell = cell;
        std::vector<Vec3> directions = nearest_directions(part, at_cell);
        directions.push_back(part.grid.centres[cell]);  // reaches all of Group I
        for (const SectorCandidate& sector :
             sector_candidates(part.grid.centres[cell], directions, SetupMode::Paper))
            least = std::min(least, sector.area());
    }
    return {{"change_with_group_1", std::abs(least / search.least.value().area - 1)}};
}

NamedCells saving_cells(const StudiedPart& part)
{
    const SetupSavings savings = setup_savings(part);
    const PoseSearchResult search =
        pose_search(part.visibility.map, part.grid.centres, {});
    return {
        {"group_1_percent", savings.group_1_percent},
        {"group_2_mean", savings.group_2_mean},
        {"nearest_cells_mean", savings.nearest_cells_mean},
        {"left_by_best_direction", count(part.visibility.map.facets() -
                                         widest_direction(part.visibility.map).facets)},
        {"ca_paper_area_deg2", square_degrees(search.least.value().area)}};
}

}  // namespace endmill
