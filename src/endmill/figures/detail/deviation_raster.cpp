// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/detail/deviation_raster.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/deviation/detail/deviation_cells.h"

// The raster is made in these steps:
//
// 1. The extent of the part in x and y is found from the corners of the tiles. Only tiles
//    that might bulge beyond this extent are examined cell by cell.
// 2. The tiles are divided into a fixed number of batches. Each batch is painted on a
//    raster of its own by one thread: small cells at their centre only, large cells at a
//    grid of points half a square apart.
// 3. The rasters are merged in the order of the batches. In each square the largest share
//    of the limit wins, with a rule for equal shares, so the result does not depend on
//    the threads.

namespace endmill {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

// Number of batches of tiles: enough to occupy the threads, and fixed, so that the
// division does not depend on their number.
constexpr std::size_t batches = 32;

// A cell of a pitch up to this share of a square is painted at its centre only. Cells
// with sides of up to half a square need no more points; the sides of a cell are at most
// about 1.2 pitches, so this share leaves a margin.
constexpr double small_share = 0.25;

// Calls `body(index in the deviation, index in the tile)` for each cell of a tile that
// has an area.
template <typename Body>
void for_cells(const Deviation& deviation, const PartTile& tile, const Body& body)
{
    for (int k = 0; k < tile.cells(); ++k) {
        const std::size_t number = tile.first + static_cast<std::size_t>(k);
        if (deviation.area[number] > 0)
            body(number, static_cast<std::size_t>(k));
    }
}

// Calls `body(batch, index of a tile)` for all tiles, those of a batch in order.
template <typename Body>
void for_tiles(const Deviation& deviation, const Body& body)
{
    const std::size_t tiles = deviation.tiles.size();
    parallel_for(batches, [&](std::size_t begin, std::size_t end) {
        for (std::size_t batch = begin; batch < end; ++batch)
            for (std::size_t t = batch * tiles / batches;
                 t < (batch + 1) * tiles / batches; ++t)
                body(batch, t);
    });
}

// The smallest box around all boxes.
AlignedBox2d united(const std::array<AlignedBox2d, batches>& boxes)
{
    AlignedBox2d whole;
    for (const AlignedBox2d& box : boxes)
        whole.extend(box);
    return whole;
}

// The extent of the corners of a tile. Corners without a ray are left out.
AlignedBox2d box_of_corners(const PartCharts& charts, const PartTile& tile)
{
    require(tile.whole.chart < charts.count(),
            "Deviation: need the charts that were measured");
    AlignedBox2d box;
    for (int k = 0; k < tile.whole.corners; ++k)
        if (const auto ray =
                charts.ray(tile.whole.chart, tile.whole.at[static_cast<std::size_t>(k)]))
            box.extend(ray->point.head<2>());
    return box;
}

// The extent of the part: of the corners of the tiles, and of the centres of cells where
// these might lie outside. A tile is assumed to bulge by less than its own size.
AlignedBox2d box_of(const PartCharts& charts, const Deviation& deviation)
{
    std::vector<AlignedBox2d> of_tile(deviation.tiles.size());
    std::array<AlignedBox2d, batches> boxes;
    for_tiles(deviation, [&](std::size_t batch, std::size_t t) {
        of_tile[t] = box_of_corners(charts, deviation.tiles[t]);
        boxes[batch].extend(of_tile[t]);
    });
    const AlignedBox2d corners = united(boxes);
    for_tiles(deviation, [&](std::size_t batch, std::size_t t) {
        const AlignedBox2d& own = of_tile[t];
        const Vector2d bulge = own.isEmpty() ? Vector2d{0, 0} : Vector2d{own.sizes()};
        if (!own.isEmpty() && corners.contains(own.min() - bulge) &&
            corners.contains(own.max() + bulge))
            return;
        const std::vector<Vec3> points = tile_points(charts, deviation.tiles[t]);
        for_cells(deviation, deviation.tiles[t], [&](std::size_t, std::size_t k) {
            boxes[batch].extend(points[k].head<2>());
        });
    });
    return united(boxes);
}

// The raster of a box: squares along its longer side, and as many rows or columns as the
// other side needs.
DeviationRaster empty_raster(const AlignedBox2d& box, int squares)
{
    DeviationRaster raster;
    if (!box.isEmpty()) {
        require(box.min().allFinite() && box.max().allFinite(),
                "deviation_raster: a number is not finite");
        raster.low = box.min();
        raster.high = box.max();
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

// A cell seen from above, approximated by its tangent plane at the centre. Lengths in
// squares.
struct Footprint {
    Vector2d middle;
    Vector2d corner;   // its first corner
    Vector2d to_next;  // sides from the first corner
    Vector2d to_last;
    bool is_triangle;

    // The point with parameters in [0, 1] x [0, 1]; the square collapses at the second
    // corner of a triangle.
    Vector2d at(double s, double t) const
    {
        return corner + s * to_next + (is_triangle ? (1 - s) * t : t) * to_last;
    }

    // The longest side in x or y, in squares.
    double longest() const
    {
        return std::max(to_next.lpNorm<Eigen::Infinity>(),
                        to_last.lpNorm<Eigen::Infinity>());
    }
};

// Paints cells on a raster.
class Painter {
public:
    Painter(const DeviationRaster& empty, const DeviationLimits& limits)
        : raster_{empty},
          limits_{limits}
    {
    }

    // Paints all cells of a tile that have an area.
    void paint(const PartCharts& charts, const Deviation& deviation, const PartTile& tile)
    {
        if (deviation.pitch_mm > 0 && deviation.pitch_mm <= small_share * raster_.side) {
            const std::vector<Vec3> points = tile_points(charts, tile);
            for_cells(deviation, tile, [&](std::size_t number, std::size_t k) {
                take(in_squares(points[k]), deviation.left[number]);
            });
            return;
        }
        const std::vector<PartRay> rays = tile_rays(charts, tile);
        for_cells(deviation, tile, [&](std::size_t number, std::size_t k) {
            require(has_normal(rays[k]), "Deviation: need the charts that were measured");
            paint(tile.cell(static_cast<int>(k)), rays[k], deviation.left[number]);
        });
    }

    // Merges another raster of the same squares.
    void paint(const DeviationRaster& other)
    {
        for (int row = 0; row < other.rows; ++row)
            for (int column = 0; column < other.columns; ++column)
                if (other.at(column, row) != DeviationRaster::nothing)
                    take(column, row, other.at(column, row));
    }

    const DeviationRaster& raster() const { return raster_; }

private:
    // Paints one cell at its centre and, if it is large, at a grid of points.
    void paint(const PartCell& cell, const PartRay& ray, float left)
    {
        const Footprint print = footprint(cell, ray);
        take(print.middle, left);
        // Points half a square apart reach every square that the cell covers by half a
        // square.
        const double places = std::ceil(2 * print.longest());
        const int most = 4 * std::max(raster_.columns, raster_.rows);
        const int steps = places < most ? static_cast<int>(places) : most;
        for (int j = 0; steps > 1 && j < steps; ++j)
            for (int i = 0; i < steps; ++i)
                take(print.at((i + 0.5) / steps, (j + 0.5) / steps), left);
    }

    // A point in units of squares from the corner of the raster.
    Vector2d in_squares(const Vec3& point) const
    {
        return (point.head<2>() - raster_.low) / raster_.side;
    }

    // The cell seen from above; the sides follow from the partial derivatives at its
    // centre.
    Footprint footprint(const PartCell& cell, const PartRay& ray) const
    {
        const auto seen = [&](const Vector2d& way) -> Vector2d {
            return (way.x() * ray.du + way.y() * ray.dv).head<2>() / raster_.side;
        };
        const auto last = static_cast<std::size_t>(cell.corners - 1);
        const Vector2d middle = in_squares(ray.point);
        return {middle, middle + seen(cell.at[0] - cell.centre()),
                seen(cell.at[1] - cell.at[0]), seen(cell.at[last] - cell.at[0]),
                cell.corners == 3};
    }

    // Records a deviation at a point. Points outside the raster, by rounding or by the
    // curvature of the cell, count for the nearest square.
    void take(const Vector2d& place, float left)
    {
        if (!place.allFinite())
            return;
        take(static_cast<int>(
                 std::clamp(std::floor(place.x()), 0.0, raster_.columns - 1.0)),
             static_cast<int>(std::clamp(std::floor(place.y()), 0.0, raster_.rows - 1.0)),
             left);
    }

    // Records a deviation in a square: the larger share of the limit wins, of two equal
    // shares the gouge.
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
    std::vector<Painter> painters(batches, Painter{empty, limits});
    for_tiles(deviation, [&](std::size_t batch, std::size_t t) {
        painters[batch].paint(charts, deviation, deviation.tiles[t]);
    });
    for (std::size_t batch = 1; batch < batches; ++batch)
        painters.front().paint(painters[batch].raster());
    return painters.front().raster();
}

}  // namespace endmill
