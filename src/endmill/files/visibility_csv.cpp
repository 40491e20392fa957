// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/result_csv.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "endmill/files/csv.h"

namespace endmill {

void write_visibility_csv(const VisibilityMap& map, const OutputFolder::Sink& sink)
{
    std::string header = "facet";
    for (std::size_t cell = 0; cell < map.cells(); ++cell)
        header += ",cell_" + std::to_string(cell);
    sink(header + '\n');
    // The map is stored by columns (cells), the file by rows (facets). A word of a column
    // holds 64 facets, so 64 rows are written at a time and every word is read once.
    std::vector<std::uint64_t> blocked(map.cells());
    for (std::size_t word = 0; word < map.words(); ++word) {
        for (std::size_t cell = 0; cell < map.cells(); ++cell)
            blocked[cell] = ~map.column(cell)[word];
        const std::size_t end = std::min(map.facets(), 64 * (word + 1));
        std::string rows;
        for (std::size_t facet = 64 * word; facet < end; ++facet) {
            rows += std::to_string(facet);
            for (const std::uint64_t bits : blocked) {
                rows += ',';
                rows += static_cast<char>('0' + (bits >> (facet % 64) & 1U));
            }
            rows += '\n';
        }
        sink(rows);
    }
}

std::string cones_csv(const PartVisibility& visibility,
                      std::span<const double> solid_angles_sr)
{
    const std::vector<double> fractions =
        visible_fractions(visibility.map, solid_angles_sr);
    CsvTable table{{"facet", "visible_fraction"}};
    for (std::size_t facet = 0; facet < fractions.size(); ++facet) {
        const bool has_cone = !std::ranges::binary_search(visibility.dropped, facet);
        table.add_row({static_cast<std::int64_t>(facet),
                       has_cone ? CsvCell{fractions[facet]} : CsvCell{}});
    }
    return table.text();
}

}  // namespace endmill
