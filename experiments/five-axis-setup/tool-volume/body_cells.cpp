// SPDX-License-Identifier: GPL-3.0-or-later
#include "five-axis-setup/tool-volume/body_cells.h"

#include <bit>
#include <cstdint>

#include "endmill/setup/detail/arc_search.h"
#include "endmill/setup/pose_search.h"
#include "support/setup_cells.h"

namespace endmill {
namespace {

std::int64_t entries(const VisibilityMap& map)
{
    std::int64_t sum = 0;
    for (std::size_t cell = 0; cell < map.cells(); ++cell)
        for (const std::uint64_t word : map.column(cell))
            sum += std::popcount(word);
    return sum;
}

CsvCell least_area(const StudiedPart& part, RotaryFamily family)
{
    const auto found = pose_search(part.visibility.map, part.grid.centres,
                                   {.family = family, .mode = SetupMode::Corrected});
    return found.least ? CsvCell{square_degrees(found.least->area)} : CsvCell{};
}

}  // namespace

NamedCells body_cells(const StudiedPart& part, const StudiedPart& bare)
{
    const std::int64_t all_entries = entries(bare.visibility.map);
    const VisibilityMap& map = part.visibility.map;
    const std::int64_t left = entries(map);
    return {
        {"accessible_entries", left},
        {"lost_percent",
         100 * (1 - static_cast<double>(left) / static_cast<double>(all_entries))},
        {"empty_cones", static_cast<std::int64_t>(empty_cones(part.visibility).size())},
        {"left_by_best_direction",
         static_cast<std::int64_t>(map.facets() - widest_direction(map).facets)},
        {"ca_area_deg2", least_area(part, RotaryFamily::CA)},
        {"ab_area_deg2", least_area(part, RotaryFamily::AB)}};
}

}  // namespace endmill
