// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/deviation_cells.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "endmill/core/error.h"

namespace endmill {
namespace {

// Returns the value that the given share of the area does not exceed. It uses a histogram
// over the leading bits of the values, whose bins are 1/2048 of the value wide.
double area_quantile(std::span<const float> values, std::span<const float> areas,
                     double share)
{
    constexpr int dropped_bits = 12;
    std::vector<double> bins(std::size_t{1} << (32 - 1 - dropped_bits));
    double total = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        // Not -0, which has the sign bit set.
        const float value = values[i] > 0 ? values[i] : 0.0F;
        bins[std::bit_cast<std::uint32_t>(value) >> dropped_bits] += areas[i];
        total += areas[i];
    }
    double sum = 0;
    for (std::uint32_t bin = 0; bin < bins.size(); ++bin) {
        sum += bins[bin];
        if (bins[bin] > 0 && sum >= share * total)
            return std::bit_cast<float>(bin << dropped_bits);
    }
    return 0;
}

}  // namespace

void require_whole(const Deviation& deviation)
{
    const std::size_t cells = cell_count(deviation.tiles);
    require(deviation.left.size() == cells && deviation.area.size() == cells,
            "Deviation: need a value and an area for each cell");
    // Counting all cells is faster than a search that stops at the first, because the
    // compiler vectorises it.
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

void add_areas(Deviation& deviation)
{
    double rest = 0;
    for (std::size_t i = 0; i < deviation.left.size(); ++i) {
        const double left = deviation.left[i];
        const double area = deviation.area[i];
        deviation.area_mm2 += area;
        rest += area * std::max(left, 0.0);
    }
    if (deviation.area_mm2 > 0)
        deviation.mean_scallop_mm = rest / deviation.area_mm2;
    deviation.p99_scallop_mm = area_quantile(deviation.left, deviation.area, 0.99);
}

}  // namespace endmill
