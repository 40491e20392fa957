// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/part_tiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "endmill/core/detail/large_pages.h"
#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/core/text.h"

// A chart is halved until its sides are at most eight pitches long, across the longer
// side; a triangle is quartered. The piece then becomes a tile of up to 8 by 8 cells.

namespace endmill {
namespace {

using Eigen::Vector2d;

constexpr int most_across = 8;  // greatest number of cells along a side of a tile
// A cell may be longer than the pitch by this share of it, where one more cell would make
// all of them much shorter.
constexpr double spared_share = 0.2;
// Limit of halvings of a chart; beyond it the cells would exceed any memory.
constexpr int most_halvings = 40;

// Greatest lengths of a cell's sides.
struct Sides {
    double along_u;  // mm
    double along_v;
};

// The rays at the corners of a cell; none where there is no normal, and none for a missing
// fourth corner.
using RaysAtCorners = std::array<std::optional<PartRay>, 4>;

RaysAtCorners rays_at_corners(const PartCharts& charts, const PartCell& cell)
{
    RaysAtCorners rays;
    for (std::size_t k = 0; k < static_cast<std::size_t>(cell.corners); ++k)
        rays[k] = charts.ray(cell.chart, cell.at[k]);
    return rays;
}

// Estimates the lengths from the partials at the cell's corners and middle.
Sides sides_of(const PartCharts& charts, const PartCell& cell,
               const RaysAtCorners& corners)
{
    Sides sides{0, 0};
    const Vector2d first = cell.at[1] - cell.at[0];
    const Vector2d last =
        cell.at[static_cast<std::size_t>(cell.corners - 1)] - cell.at[0];
    const auto take = [&](const std::optional<PartRay>& ray) {
        if (!ray)
            return;
        sides.along_u =
            std::max(sides.along_u, (first.x() * ray->du + first.y() * ray->dv).norm());
        const Vec3 up = last.x() * ray->du + last.y() * ray->dv;
        sides.along_v = std::max(sides.along_v, up.norm());
        if (cell.corners == 3)
            sides.along_v = std::max(
                sides.along_v, (up - first.x() * ray->du - first.y() * ray->dv).norm());
    };
    for (const std::optional<PartRay>& ray : corners)
        take(ray);
    take(charts.ray(cell.chart, cell.centre()));
    return sides;
}

// A cell with the rays at its corners.
struct CornerCell {
    PartCell cell;
    RaysAtCorners rays;
};

// Halves a quadrilateral across its sides along `across`. Only the two new corners are
// evaluated.
std::array<CornerCell, 2> halves(const PartCharts& charts, const CornerCell& whole,
                                 Parameter across)
{
    CornerCell low = whole;
    CornerCell high = whole;
    // Puts a new corner between corners a and b, b that of the high half.
    const auto divide = [&](std::size_t a, std::size_t b) {
        const Vector2d middle = (whole.cell.at[a] + whole.cell.at[b]) / 2;
        low.cell.at[b] = high.cell.at[a] = middle;
        low.rays[b] = high.rays[a] = charts.ray(whole.cell.chart, middle);
    };
    if (across == Parameter::U) {
        divide(0, 1);
        divide(3, 2);
    } else {
        divide(0, 3);
        divide(1, 2);
    }
    return {low, high};
}

// Parameters of the middles of a tile's columns and rows. Cells of a patch lie along its
// parameters.
struct Middles {
    std::vector<double> u;
    std::vector<double> v;
};

// \param cells of the tile, in order.
Middles middles_of(const PartTile& tile, std::span<const PartCell> cells)
{
    const auto columns = static_cast<std::size_t>(tile.columns);
    Middles middles;
    middles.u.reserve(most_across);
    middles.v.reserve(most_across);
    for (std::size_t i = 0; i < columns; ++i)
        middles.u.push_back(cells[i].centre().x());
    for (std::size_t first = 0; first < cells.size(); first += columns)
        middles.v.push_back(cells[first].centre().y());
    return middles;
}

// Returns the tiles of all charts, in order. Those of a single chart are not copied.
std::vector<PartTile> joined(std::vector<std::vector<PartTile>> of_chart)
{
    if (of_chart.size() == 1)
        return std::move(of_chart.front());
    std::size_t count = 0;
    for (const std::vector<PartTile>& some : of_chart)
        count += some.size();
    std::vector<PartTile> tiles;
    reserve_in_large_pages(tiles, count);
    for (std::vector<PartTile>& some : of_chart) {
        tiles.insert(tiles.end(), some.begin(), some.end());
        some = {};
    }
    return tiles;
}

// Cuts one chart after the other into tiles.
class Tiling {
public:
    Tiling(const PartCharts& charts, double pitch, std::size_t most_cells)
        : charts_{charts},
          pitch_{pitch},
          most_cells_{most_cells}
    {
    }

    std::vector<PartTile> tiles_of(std::uint32_t chart)
    {
        tiles_.clear();
        cells_ = 0;
        add(charts_.whole(chart), 0);
        return std::move(tiles_);
    }

private:
    void add(const PartCell& cell, int halvings)
    {
        add({cell, rays_at_corners(charts_, cell)}, halvings);
    }

    void add(const CornerCell& piece, int halvings)
    {
        const PartCell& cell = piece.cell;
        const Sides sides = sides_of(charts_, cell, piece.rays);
        const double longest = std::max(sides.along_u, sides.along_v);
        if (longest <= most_across * pitch_ || halvings >= most_halvings) {
            keep(cell, sides);
        } else if (cell.corners == 3) {
            for (const PartCell& quarter : cell.quarters())
                add(quarter, halvings + 1);
        } else {
            for (const CornerCell& half :
                 halves(charts_, piece,
                        sides.along_u >= sides.along_v ? Parameter::U : Parameter::V))
                add(half, halvings + 1);
        }
    }

    void keep(const PartCell& cell, const Sides& sides)
    {
        const auto across = [&](double side) {
            return std::clamp(static_cast<int>(std::ceil(side / pitch_ - spared_share)),
                              1, most_across);
        };
        int columns = across(sides.along_u);
        int rows = across(sides.along_v);
        if (cell.corners == 3)
            columns = rows = std::max(columns, rows);
        tiles_.push_back({cell, columns, rows, 0});
        cells_ += static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
        if (cells_ > most_cells_)
            throw LimitError{"a pitch of " + to_text(pitch_) +
                             " mm cuts the part into "
                             "more than " +
                             counted(most_cells_, "cell")};
    }

    const PartCharts& charts_;
    double pitch_;
    std::size_t most_cells_;
    std::size_t cells_ = 0;
    std::vector<PartTile> tiles_;
};

}  // namespace

std::vector<PartCell> tile_cells(const PartTile& tile)
{
    std::vector<PartCell> cells;
    cells.reserve(static_cast<std::size_t>(tile.cells()));
    if (tile.whole.corners == 3) {
        for (int k = 0; k < tile.cells(); ++k)
            cells.push_back(tile.cell(k));
        return cells;
    }
    const auto& at = tile.whole.at;
    std::array<Vector2d, most_across + 1> along;
    for (int i = 0; i <= tile.columns; ++i)
        along[static_cast<std::size_t>(i)] =
            at[0] + i / double(tile.columns) * (at[1] - at[0]);
    for (int j = 0; j < tile.rows; ++j) {
        const Vector2d low = j / double(tile.rows) * (at[3] - at[0]);
        const Vector2d high = (j + 1) / double(tile.rows) * (at[3] - at[0]);
        for (std::size_t i = 0; i < static_cast<std::size_t>(tile.columns); ++i)
            cells.push_back({tile.whole.chart,
                             4,
                             {along[i] + low, along[i + 1] + low, along[i + 1] + high,
                              along[i] + high}});
    }
    return cells;
}

std::vector<PartRay> tile_rays(const PartCharts& charts, const PartTile& tile)
{
    return tile_rays(charts, tile, tile_cells(tile));
}

std::vector<PartRay> tile_rays(const PartCharts& charts, const PartTile& tile,
                               std::span<const PartCell> cells)
{
    if (!charts.mesh()) {
        const Middles middles = middles_of(tile, cells);
        return charts.rays(tile.whole.chart, middles.u, middles.v);
    }
    std::vector<PartRay> rays;
    rays.reserve(cells.size());
    for (const PartCell& cell : cells)
        rays.push_back(charts.ray(cell.chart, cell.centre()).value_or(PartRay{}));
    return rays;
}

std::vector<Vec3> tile_points(const PartCharts& charts, const PartTile& tile)
{
    const std::vector<PartCell> cells = tile_cells(tile);
    if (!charts.mesh()) {
        const Middles middles = middles_of(tile, cells);
        return charts.points(tile.whole.chart, middles.u, middles.v);
    }
    std::vector<Vec3> points;
    points.reserve(static_cast<std::size_t>(tile.cells()));
    for (const PartRay& ray : tile_rays(charts, tile, cells))
        points.push_back(ray.point);
    return points;
}

std::vector<PartTile> part_tiles(const PartCharts& charts, double pitch,
                                 std::size_t most_cells)
{
    require(std::isfinite(pitch) && pitch > 0, "part_tiles: need 0 < pitch");
    std::vector<std::vector<PartTile>> of_chart(charts.count());
    parallel_for(charts.count(), [&](std::size_t begin, std::size_t end) {
        Tiling tiling{charts, pitch, most_cells};
        for (std::size_t i = begin; i < end; ++i)
            of_chart[i] = tiling.tiles_of(static_cast<std::uint32_t>(i));
    });
    std::vector<PartTile> tiles = joined(std::move(of_chart));
    std::size_t cells = 0;
    for (PartTile& tile : tiles) {
        tile.first = cells;
        cells += static_cast<std::size_t>(tile.cells());
    }
    if (cells > most_cells)
        throw LimitError{"a pitch of " + to_text(pitch) + " mm cuts the part into " +
                         counted(cells, "cell") + "; expected at most " +
                         std::to_string(most_cells)};
    return tiles;
}

std::size_t cell_count(const std::vector<PartTile>& tiles)
{
    return tiles.empty()
               ? 0
               : tiles.back().first + static_cast<std::size_t>(tiles.back().cells());
}

}  // namespace endmill
