// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/io/deviation_raster.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/io/deviation_cells.h"

namespace endmill {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

// The tiles are drawn in so many lots, each on a raster of its own: enough for the threads
// there are, and a fixed number, so that the lots are the same for every number of them.
constexpr std::size_t lots = 32;

// Calls `body(cell number, cell, ray)` for the cells of a tile with an area.
template <typename Body>
void for_cells(const PartCharts& charts, const Deviation& deviation, const PartTile& tile,
               const Body& body)
{
    require(tile.whole.chart < charts.count(),
            "Deviation: need the charts that were measured");
    const auto rays = tile_rays(charts, tile);
    for (int k = 0; k < tile.cells(); ++k) {
        const std::size_t number = tile.first + static_cast<std::size_t>(k);
        if (!(deviation.area[number] > 0))
            continue;
        const auto& ray = rays[static_cast<std::size_t>(k)];
        require(ray.has_value(), "Deviation: need the charts that were measured");
        body(number, tile.cell(k), *ray);
    }
}

// Calls `body(lot, tile)` for all tiles, those of a lot in order.
template <typename Body>
void for_tiles(const Deviation& deviation, const Body& body)
{
    const std::size_t tiles = deviation.tiles.size();
    parallel_for(lots, [&](std::size_t begin, std::size_t end) {
        for (std::size_t lot = begin; lot < end; ++lot)
            for (std::size_t t = lot * tiles / lots; t < (lot + 1) * tiles / lots; ++t)
                body(lot, deviation.tiles[t]);
    });
}

AlignedBox2d united(const std::array<AlignedBox2d, lots>& boxes)
{
    AlignedBox2d whole;
    for (const AlignedBox2d& box : boxes)
        whole.extend(box);
    return whole;
}

AlignedBox2d box_of_corners(const PartCharts& charts, const PartTile& tile)
{
    AlignedBox2d box;
    for (int k = 0; k < tile.whole.corners; ++k)
        if (const auto ray =
                charts.ray(tile.whole.chart, tile.whole.at[static_cast<std::size_t>(k)]))
            box.extend(ray->point.head<2>());
    return box;
}

// Of the tiles' corners, and of the middles of cells where these might lie outside: a
// tile bulges by less than its own size.
AlignedBox2d box_of(const PartCharts& charts, const Deviation& deviation)
{
    std::array<AlignedBox2d, lots> boxes;
    for_tiles(deviation, [&](std::size_t lot, const PartTile& tile) {
        boxes[lot].extend(box_of_corners(charts, tile));
    });
    const AlignedBox2d corners = united(boxes);
    for_tiles(deviation, [&](std::size_t lot, const PartTile& tile) {
        const AlignedBox2d own = box_of_corners(charts, tile);
        const Vector2d bulge = own.isEmpty() ? Vector2d{0, 0} : Vector2d{own.sizes()};
        if (!own.isEmpty() && corners.contains(own.min() - bulge) &&
            corners.contains(own.max() + bulge))
            return;
        for_cells(charts, deviation, tile,
                  [&](std::size_t, const PartCell&, const PartRay& ray) {
                      boxes[lot].extend(ray.point.head<2>());
                  });
    });
    return united(boxes);
}

DeviationRaster empty_raster(const AlignedBox2d& box, int squares)
{
    DeviationRaster raster;
    if (!box.isEmpty()) {
        require(box.min().allFinite() && box.max().allFinite(),
                "deviation_raster: a number is not finite");
        raster.low = box.min();
        const double longest = box.sizes().maxCoeff();
        if (longest > 0)
            raster.side = longest / squares;
        const auto across = [&](double size) {
            return std::clamp(static_cast<int>(std::ceil(size / raster.side)), 1,
                              squares);
        };
        raster.columns = across(box.sizes().x());
        raster.rows = across(box.sizes().y());
    }
    raster.left.assign(
        static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows),
        DeviationRaster::nothing);
    return raster;
}

// A cell seen from above, flat as it is at its middle. In squares.
struct Footprint {
    Vector2d middle;
    Vector2d corner;   // the first
    Vector2d to_next;  // from there, along both of its sides
    Vector2d to_last;
    bool is_triangle;

    // In [0, 1] by [0, 1], which a triangle has narrow at its second corner.
    Vector2d at(double s, double t) const
    {
        return corner + s * to_next + (is_triangle ? (1 - s) * t : t) * to_last;
    }

    double longest() const
    {
        return std::max(to_next.lpNorm<Eigen::Infinity>(),
                        to_last.lpNorm<Eigen::Infinity>());
    }
};

class Painter {
public:
    Painter(const DeviationRaster& empty, const DeviationLimits& limits)
        : raster_{empty},
          limits_{limits}
    {
    }

    void paint(const PartCell& cell, const PartRay& ray, float left)
    {
        const Footprint print = footprint(cell, ray);
        take(print.middle, left);
        // At half a square from each other the places miss no square within the cell.
        const double places = std::ceil(2 * print.longest());
        const int most = 4 * std::max(raster_.columns, raster_.rows);
        const int steps = places < most ? static_cast<int>(places) : most;
        for (int j = 0; steps > 1 && j < steps; ++j)
            for (int i = 0; i < steps; ++i)
                take(print.at((i + 0.5) / steps, (j + 0.5) / steps), left);
    }

    void paint(const DeviationRaster& other)
    {
        for (int row = 0; row < other.rows; ++row)
            for (int column = 0; column < other.columns; ++column)
                if (other.at(column, row) != DeviationRaster::nothing)
                    take(column, row, other.at(column, row));
    }

    const DeviationRaster& raster() const { return raster_; }

private:
    Footprint footprint(const PartCell& cell, const PartRay& ray) const
    {
        const auto seen = [&](const Vector2d& way) -> Vector2d {
            return (way.x() * ray.du + way.y() * ray.dv).head<2>() / raster_.side;
        };
        const auto last = static_cast<std::size_t>(cell.corners - 1);
        const Vector2d middle = (ray.point.head<2>() - raster_.low) / raster_.side;
        return {middle, middle + seen(cell.at[0] - cell.centre()),
                seen(cell.at[1] - cell.at[0]), seen(cell.at[last] - cell.at[0]),
                cell.corners == 3};
    }

    // What lies outside is on the border but for rounding, and the cell's own bend.
    void take(const Vector2d& place, float left)
    {
        if (!place.allFinite())
            return;
        take(static_cast<int>(
                 std::clamp(std::floor(place.x()), 0.0, raster_.columns - 1.0)),
             static_cast<int>(std::clamp(std::floor(place.y()), 0.0, raster_.rows - 1.0)),
             left);
    }

    void take(int column, int row, float left)
    {
        float& there = raster_.left[static_cast<std::size_t>(row) *
                                        static_cast<std::size_t>(raster_.columns) +
                                    static_cast<std::size_t>(column)];
        if (there == DeviationRaster::nothing) {
            there = left;
            return;
        }
        const double share = share_of_limit(left, limits_);
        const double before = share_of_limit(there, limits_);
        if (share > before || (share == before && left < there))
            there = left;
    }

    DeviationRaster raster_;
    DeviationLimits limits_;
};

}  // namespace

double share_of_limit(double left, const DeviationLimits& limits)
{
    return left < 0 ? -left / limits.tolerance : left / limits.scallop;
}

DeviationRaster deviation_raster(const PartCharts& charts, const Deviation& deviation,
                                 const DeviationLimits& limits, int squares)
{
    require(squares > 0, "deviation_raster: need squares > 0");
    require(std::isfinite(limits.tolerance) && limits.tolerance > 0 &&
                std::isfinite(limits.scallop) && limits.scallop > 0,
            "deviation_raster: need limits that are finite and positive");
    require_whole(deviation);
    const DeviationRaster empty = empty_raster(box_of(charts, deviation), squares);
    std::vector<Painter> painters(lots, Painter{empty, limits});
    for_tiles(deviation, [&](std::size_t lot, const PartTile& tile) {
        for_cells(charts, deviation, tile,
                  [&](std::size_t number, const PartCell& cell, const PartRay& ray) {
                      painters[lot].paint(cell, ray, deviation.left[number]);
                  });
    });
    for (std::size_t lot = 1; lot < lots; ++lot)
        painters.front().paint(painters[lot].raster());
    return painters.front().raster();
}

}  // namespace endmill
