// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/earlier_gouge.h"

#include <algorithm>

#include "endmill/core/parallel.h"
#include "endmill/verification/detail/stock_ray.h"

namespace endmill {
namespace {

// The greatest missing length on the rays of some tiles: certain, and possible.
struct Missing {
    double found = 0;
    std::optional<Vec3> at = {};
    double most = 0;

    void take(const PartRay& ray, double certain, double possible)
    {
        if (certain > found) {
            found = certain;
            at = ray.point;
        }
        most = std::max({most, certain, possible});
    }
    // Of equal depths the first stays.
    void merge(const Missing& other)
    {
        if (other.found > found) {
            found = other.found;
            at = other.at;
        }
        most = std::max(most, other.most);
    }
};

// Measures the rays of a tile.
Missing missing_below(const PartCharts& charts, const PartTile& tile,
                      const HeightStock& stock)
{
    Missing missing;
    const std::vector<PartRay> rays = tile_rays(charts, tile);
    const std::vector<PartCell> cells = tile_cells(tile);
    for (std::size_t k = 0; k < rays.size(); ++k)
        if (has_normal(rays[k]))
            missing.take(rays[k], -ray_in_stock(stock, rays[k]).thickness,
                         most_missing(stock, rays[k], cells[k].reach(rays[k])));
    return missing;
}

}  // namespace

EarlierGouge earlier_gouge(const PartCharts& charts, std::span<const PartTile> tiles,
                           const HeightStock& stock)
{
    std::vector<Missing> of_tile(tiles.size());
    parallel_for(tiles.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            of_tile[i] = missing_below(charts, tiles[i], stock);
    });
    Missing all;
    for (const Missing& some : of_tile)
        all.merge(some);
    return {all.found, all.at, all.most - all.found};
}

}  // namespace endmill
