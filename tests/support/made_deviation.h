// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/deviation/detail/part_tiles.h"
#include "endmill/deviation/deviation.h"

namespace endmill {

/// Returns a deviation with prescribed values: thickness `left(point)` mm on each cell of
/// `pitch` mm.
template <typename Left>
Deviation made_deviation(const PartCharts& charts, double pitch, const Left& left)
{
    Deviation made;
    made.pitch_mm = pitch;
    made.tiles = part_tiles(charts, pitch, 1'000'000);
    for (const PartTile& tile : made.tiles)
        for (int k = 0; k < tile.cells(); ++k) {
            const PartCell cell = tile.cell(k);
            const auto ray = charts.ray(cell.chart, cell.centre());
            made.left.push_back(ray ? static_cast<float>(left(ray->point)) : 0);
            made.area.push_back(ray ? static_cast<float>(cell.area(*ray)) : 0);
            made.area_mm2 += made.area.back();
        }
    return made;
}

}  // namespace endmill
