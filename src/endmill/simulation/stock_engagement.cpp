// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/simulation/stock_engagement.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/simulation/removable_path.h"
#include "endmill/simulation/tile_cut.h"

namespace endmill {
namespace {

using std::numbers::pi;

// Of a cylinder that is sunk deep into the stock, so that rings do not grow without bound.
constexpr int most_cylinder_rings = 1000;

// The rings of a cutter from its tip to `height` above it, nothing engaged.
std::vector<EngagedRing> rings_of(const Cutter& cutter, int rings, double height)
{
    const double r = cutter.corner_radius();
    const double c = cutter.flat_radius();
    const double width = (cutter.is_flat() ? cutter.radius() : r * pi / 2) / rings;
    std::vector<EngagedRing> all;
    const int on_bottom = static_cast<int>(std::ceil(c / width));
    const double on_cylinder = std::clamp(std::ceil((height - r) / width), 0.0,
                                          static_cast<double>(most_cylinder_rings));
    all.reserve(static_cast<std::size_t>(on_bottom) + rings +
                static_cast<std::size_t>(on_cylinder));
    for (int k = 0; k < on_bottom; ++k)
        all.push_back({0, c * (k + 0.5) / on_bottom, 0, c / on_bottom, {}});
    for (int k = 0; k < rings && !cutter.is_flat(); ++k) {
        const double latitude = pi / 2 * (k + 0.5) / rings;
        all.push_back({latitude,
                       c + r * std::sin(latitude),
                       r - r * std::cos(latitude),
                       width,
                       {}});
    }
    for (int k = 0; k < most_cylinder_rings && r + (k + 0.5) * width < height; ++k)
        all.push_back({pi / 2, cutter.radius(), r + (k + 0.5) * width, width, {}});
    return all;
}

// A place of a line of `count` cells, between two of their centres.
struct BetweenCells {
    int cell;      // the one before it
    int next;      // the one after it; the same at the border
    double share;  // of the next one
};

// \param place in cells from where the line begins, in 0 … count.
BetweenCells between_cells(double place, int count)
{
    const double from_centre = std::clamp(place - 0.5, 0.0, count - 1.0);
    const int cell = static_cast<int>(from_centre);
    return {cell, std::min(cell + 1, count - 1), from_centre - cell};
}

// Height at a place, linear between the centres of the cells; nothing beside the grid.
std::optional<double> height_under(const HeightStock& stock, double x, double y)
{
    const StockGrid& grid = stock.grid();
    const double column = (x - grid.low_x) / grid.pitch;
    const double row = (y - grid.low_y) / grid.pitch;
    if (!(column >= 0 && column <= grid.columns && row >= 0 && row <= grid.rows))
        return std::nullopt;
    const BetweenCells i = between_cells(column, grid.columns);
    const BetweenCells j = between_cells(row, grid.rows);
    return std::lerp(
        std::lerp(stock.height(i.cell, j.cell), stock.height(i.next, j.cell), i.share),
        std::lerp(stock.height(i.cell, j.next), stock.height(i.next, j.next), i.share),
        j.share);
}

// A place of the cutter in the middle of a move.
struct Pose {
    Vec3 tip;
    Vec3 way;       // of the move, unit
    double feed_x;  // the direction of azimuth 0
    double feed_y;
};

bool is_engaged(const HeightStock& stock, const Pose& pose, const EngagedRing& ring,
                double azimuth)
{
    const double cosine = std::cos(azimuth);
    const double sine = std::sin(azimuth);
    const Vec3 outwards{pose.feed_x * cosine - pose.feed_y * sine,
                        pose.feed_y * cosine + pose.feed_x * sine, 0};
    const Vec3 normal =
        std::sin(ring.latitude) * outwards - std::cos(ring.latitude) * Vec3::UnitZ();
    if (normal.dot(pose.way) <= 0)
        return false;
    const Vec3 place = pose.tip + ring.radius * outwards;
    const auto height = height_under(stock, place.x(), place.y());
    return height && *height > stock.grid().bottom_z &&
           *height > pose.tip.z() + ring.above;
}

void find_intervals(const HeightStock& stock, const Pose& pose, int azimuths,
                    EngagedRing& ring)
{
    for (int k = 0; k < azimuths; ++k) {
        const double from = -pi + 2 * pi * k / azimuths;
        const double to = -pi + 2 * pi * (k + 1) / azimuths;
        if (!is_engaged(stock, pose, ring, (from + to) / 2))
            continue;
        if (!ring.engaged.empty() && ring.engaged.back().to == from)
            ring.engaged.back().to = to;
        else
            ring.engaged.push_back({from, to});
    }
}

struct StraightMove {
    Vec3 from;
    Vec3 to;
};

Engagement engagement_on(const HeightStock& stock, const Cutter& cutter,
                         const StraightMove& move, const EngagementOptions& options,
                         double top_z)
{
    Engagement engagement;
    const Vec3 way = move.to - move.from;
    const double length = way.norm();
    const double level = std::hypot(way.x(), way.y());
    if (length == 0 || (level == 0 && way.z() > 0))
        return engagement;
    const Pose pose{(move.from + move.to) / 2, way / length,
                    level > 0 ? way.x() / level : 1, level > 0 ? way.y() / level : 0};
    for (EngagedRing& ring : rings_of(cutter, options.rings, top_z - pose.tip.z())) {
        find_intervals(stock, pose, options.azimuths, ring);
        if (!ring.engaged.empty())
            engagement.rings.push_back(std::move(ring));
    }
    return engagement;
}

// The first and last tile of a line that a move within [low, high] may reach.
std::pair<int, int> tiles_between(double low, double high, double pitch, int tiles)
{
    const double width = HeightStock::tile_side * pitch;
    return {static_cast<int>(std::clamp(std::floor(low / width), 0.0, tiles - 1.0)),
            static_cast<int>(std::clamp(std::floor(high / width), 0.0, tiles - 1.0))};
}

void cut(HeightStock& stock, const Cutter& cutter, const SweptMove& move)
{
    const StockGrid& grid = stock.grid();
    const double reach = cutter.radius() + grid.pitch;
    const double x = move.x - grid.low_x;
    const double y = move.y - grid.low_y;
    const auto [low_x, high_x] = std::minmax({x, x + move.length * move.direction_x});
    const auto [low_y, high_y] = std::minmax({y, y + move.length * move.direction_y});
    const auto [first_column, last_column] =
        tiles_between(low_x - reach, high_x + reach, grid.pitch, stock.tile_columns());
    const auto [first_row, last_row] =
        tiles_between(low_y - reach, high_y + reach, grid.pitch, stock.tile_rows());
    for (int row = first_row; row <= last_row; ++row)
        for (int column = first_column; column <= last_column; ++column)
            cut_tile(stock.tile(column, row), tile_place(grid, column, row), cutter,
                     move);
}

}  // namespace

void for_each_engagement(
    HeightStock& stock, const ToolPath& path, const Cutter& cutter,
    const std::function<void(std::size_t number, const Engagement& engagement)>& visit,
    const EngagementOptions& options)
{
    require(options.rings >= 1 && options.azimuths >= 1,
            "for_each_engagement: need a ring and an azimuth");
    require_removable(path);
    const auto range = height_range(stock);
    const double top_z = range ? range->high : stock.grid().bottom_z;
    for (std::size_t k = 0; k < path.points.size(); ++k) {
        const Vec3& to = path.points[k].location.tip;
        const Vec3& from = k == 0 ? to : path.points[k - 1].location.tip;
        if (k > 0)
            visit(k, engagement_on(stock, cutter, {from, to}, options, top_z));
        if (k > 0 || cuts_at_start(path))
            cut(stock, cutter, swept_move(from, to));
    }
}

}  // namespace endmill
