// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/deviation_cells.h"

#include <algorithm>
#include <cmath>

#include "endmill/core/error.h"

namespace endmill {

void require_whole(const Deviation& deviation)
{
    const std::size_t cells = cell_count(deviation.tiles);
    require(deviation.left.size() == cells && deviation.area.size() == cells,
            "Deviation: need a value and an area for each cell");
    // Counted, as a search that ends at the first one looks at one after the other.
    const auto is_not_finite = [](float value) { return !std::isfinite(value); };
    require(std::ranges::count_if(deviation.left, is_not_finite) == 0 &&
                std::ranges::count_if(deviation.area, is_not_finite) == 0,
            "Deviation: a number is not finite");
}

DeviationCell deviation_cell(const PartCharts& charts, const PartTile& tile, int number)
{
    const PartCell cell = tile.cell(number);
    require(cell.chart < charts.count(), "Deviation: need the charts that were measured");
    const auto ray = charts.ray(cell.chart, cell.centre());
    require(ray.has_value(), "Deviation: need the charts that were measured");
    return {cell, *ray};
}

DeviationCell deviation_cell(const PartCharts& charts, const Deviation& deviation,
                             std::size_t number)
{
    const auto after =
        std::ranges::upper_bound(deviation.tiles, number, {}, &PartTile::first);
    const PartTile& tile = *(after - 1);
    return deviation_cell(charts, tile, static_cast<int>(number - tile.first));
}

}  // namespace endmill
