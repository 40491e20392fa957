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

// Calls `body(cell number, cell, ray)` for the cells with an area of some tiles.
template <typename Body>
void for_cells(const PartCharts& charts, const Deviation& deviation, std::size_t lot,
               const Body& body)
{
    const std::size_t tiles = deviation.tiles.size();
    for (std::size_t t = lot * tiles / lots; t < (lot + 1) * tiles / lots; ++t) {
        const PartTile& tile = deviation.tiles[t];
        for (int k = 0; k < tile.cells(); ++k) {
            const std::size_t number = tile.first + static_cast<std::size_t>(k);
            if (!(deviation.area[number] > 0))
                continue;
            const auto [cell, ray] = deviation_cell(charts, tile, k);
            body(number, cell, ray);
        }
    }
}

// Of the cells' middles, and the tiles' corners, which are those of the part too.
AlignedBox2d box_of(const PartCharts& charts, const Deviation& deviation)
{
    std::array<AlignedBox2d, lots> boxes;
    parallel_for(lots, [&](std::size_t begin, std::size_t end) {
        for (std::size_t lot = begin; lot < end; ++lot)
            for_cells(charts, deviation, lot,
                      [&](std::size_t, const PartCell&, const PartRay& ray) {
                          boxes[lot].extend(ray.point.head<2>());
                      });
    });
    AlignedBox2d whole;
    for (const AlignedBox2d& box : boxes)
        whole.extend(box);
    for (const PartTile& tile : deviation.tiles)
        for (int k = 0; k < tile.whole.corners; ++k)
            if (const auto ray = charts.ray(tile.whole.chart,
                                            tile.whole.at[static_cast<std::size_t>(k)]))
                whole.extend(ray->point.head<2>());
    return whole;
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

// A cell seen from above, in squares, flat as it is at its middle.
struct Footprint {
    std::array<Vector2d, 4> corners;
    int count;
    Vector2d middle;

    bool covers(const Vector2d& point) const
    {
        bool any_left = false;
        bool any_right = false;
        for (int k = 0; k < count; ++k) {
            const Vector2d& a = corners[static_cast<std::size_t>(k)];
            const Vector2d along = corners[static_cast<std::size_t>((k + 1) % count)] - a;
            const Vector2d to = point - a;
            const double turn = along.x() * to.y() - along.y() * to.x();
            any_left = any_left || turn > 0;
            any_right = any_right || turn < 0;
        }
        return any_left != any_right;
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
        take(column_of(print.middle.x()), row_of(print.middle.y()), left);
        AlignedBox2d box{print.middle};
        for (int k = 0; k < print.count; ++k)
            box.extend(print.corners[static_cast<std::size_t>(k)]);
        for (int row = row_of(box.min().y()); row <= row_of(box.max().y()); ++row)
            for (int column = column_of(box.min().x());
                 column <= column_of(box.max().x()); ++column)
                if (print.covers({column + 0.5, row + 0.5}))
                    take(column, row, left);
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
        const Vector2d middle = cell.centre();
        Footprint print;
        print.count = cell.corners;
        print.middle = (ray.point.head<2>() - raster_.low) / raster_.side;
        for (std::size_t k = 0; k < static_cast<std::size_t>(cell.corners); ++k) {
            const Vector2d away = cell.at[k] - middle;
            print.corners[k] =
                print.middle +
                (away.x() * ray.du + away.y() * ray.dv).head<2>() / raster_.side;
        }
        return print;
    }

    int column_of(double x) const
    {
        return static_cast<int>(std::clamp(std::floor(x), 0.0, raster_.columns - 1.0));
    }
    int row_of(double y) const
    {
        return static_cast<int>(std::clamp(std::floor(y), 0.0, raster_.rows - 1.0));
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
    parallel_for(lots, [&](std::size_t begin, std::size_t end) {
        for (std::size_t lot = begin; lot < end; ++lot)
            for_cells(charts, deviation, lot,
                      [&](std::size_t number, const PartCell& cell, const PartRay& ray) {
                          painters[lot].paint(cell, ray, deviation.left[number]);
                      });
    });
    for (std::size_t lot = 1; lot < lots; ++lot)
        painters.front().paint(painters[lot].raster());
    return painters.front().raster();
}

}  // namespace endmill
