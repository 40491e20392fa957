// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/tile_measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace endmill {
namespace {

// Shares of the limits to within which a maximum is sought, if that is more than the slack.
constexpr double scallop_sharpness = 0.05;
constexpr double gouge_sharpness = 0.25;
// Of the corner radius: the deepest place that a sweep has on a larger cell may lie beside
// what it clears of the ray at the middle.
constexpr double planes_share = 0.25;
// Of a unit normal's z: upright but for what a file's rounding makes of a wall.
constexpr double upright_z = 1e-3;

// Of a tile's own size: how far away others are still looked at together with it.
constexpr double nearby_sizes = 8;

double size_of(const RayBundle& bundle)
{
    return std::hypot(bundle.beside, bundle.above);
}

bool are_near(const RayBundle& one, const RayBundle& other)
{
    return (one.centre - other.centre).norm() <=
           nearby_sizes * std::min(size_of(one), size_of(other));
}

// The most that a maximum may turn out higher without changing anything.
double threshold(double found, double limit, double sharpness)
{
    const double raised = limit + verdict_slack;
    const double sharp = found + std::max(verdict_slack, sharpness * limit);
    return found <= raised ? std::min(sharp, raised) : sharp;
}

}  // namespace

Doubt doubt_beyond(double rest, double gouge, const DeviationLimits& limits)
{
    return {threshold(rest, limits.scallop, scallop_sharpness),
            -threshold(gouge, limits.tolerance, gouge_sharpness)};
}

bool is_beyond(double left, const DeviationLimits& limits)
{
    return left > limits.scallop || -left > limits.tolerance;
}

double shortened(double left, const PartRay& ray, const PartDistance& distance,
                 std::optional<std::size_t>& hint)
{
    const double sign = left < 0 ? -1 : 1;
    const PartWay way{ray.point, sign * ray.normal, std::abs(left)};
    return sign * distance.free_ball(way, hint).length;
}

TileMeasure::TileMeasure(const Measured& measured, const PartTile& tile)
    : TileMeasure{measured, tile, NotYetMown{}}
{
    if (rays_)
        rays_->mow(measured_.tree);
    take_rays();
}

std::vector<TileMeasure> TileMeasure::measured_together(const Measured& measured,
                                                        std::span<const PartTile> tiles)
{
    std::vector<TileMeasure> measures;
    measures.reserve(tiles.size());
    for (const PartTile& tile : tiles)
        measures.push_back(TileMeasure{measured, tile, NotYetMown{}});
    // Rays far apart have no sweeps in common.
    std::vector<MownRays*> near;
    for (TileMeasure& measure : measures) {
        if (!measure.rays_)
            continue;
        if (!near.empty() && !are_near(near.front()->bundle(), measure.rays_->bundle())) {
            MownRays::mow_together(near, measured.tree);
            near.clear();
        }
        near.push_back(&*measure.rays_);
    }
    MownRays::mow_together(near, measured.tree);
    for (TileMeasure& measure : measures)
        measure.take_rays();
    return measures;
}

TileMeasure::TileMeasure(const Measured& measured, const PartTile& tile, NotYetMown)
    : measured_{measured},
      tile_{tile},
      touches_side_{measured.charts.touches_side(tile.whole)}
{
    const auto corners = static_cast<std::size_t>(tile.whole.corners);
    bend_ = measured_.charts.bend(tile.whole.chart, tile.whole.centre());
    for (std::size_t k = 0; k < corners; ++k) {
        const PartCharts::Bend bend =
            measured_.charts.bend(tile.whole.chart, tile.whole.at[k]);
        bend_.convex = std::max(bend_.convex, bend.convex);
        bend_.any = std::max(bend_.any, bend.any);
    }
    lay_out_rays();
}

Extremes TileMeasure::extremes()
{
    Extremes found;
    for (const MeasuredCell& cell : cells_) {
        found.take(cell);
        found.bound(most_left(cell, {}), least_left(cell));
        found.add_area(cell.value(), cell.area, limits());
    }
    return found;
}

// Beside an outer wall of the part there is stock that no path over the part can reach.
bool TileMeasure::is_outer(const PartRay& ray) const
{
    return is_wall_ && !measured_.distance.is_over_or_under(
                           ray.point + measured_.options.pitch / 2 * ray.normal);
}

std::span<const std::int32_t> TileMeasure::beneath()
{
    if (!beneath_) {
        double reach = 0;
        for (const MeasuredCell& cell : cells_)
            reach = std::max(reach, cell.reach);
        beneath_ =
            rays_->sweeps_beneath(measured_.tree, reach, reach * reach * bend_.any / 2);
    }
    return *beneath_;
}

void TileMeasure::lay_out_rays()
{
    std::array<PartRay, most_tile_cells> rays;
    std::array<double, most_tile_cells> lengths;
    std::size_t count = 0;
    const std::vector<PartRay> at_middles = tile_rays(measured_.charts, tile_);
    const std::vector<PartCell> all = tile_cells(tile_);
    cells_.reserve(at_middles.size());
    numbers_.reserve(at_middles.size());
    for (int k = 0; k < tile_.cells(); ++k) {
        const PartRay& ray = at_middles[static_cast<std::size_t>(k)];
        if (!has_normal(ray))
            continue;
        const PartCell& cell = all[static_cast<std::size_t>(k)];
        rays[count] = ray;
        const MownRay in_stock = stock(ray);
        lengths[count] = in_stock.left;
        cells_.push_back({cell, ray, cell.reach(ray), in_stock, bend_});
        cells_.back().in_stock = in_stock;
        cells_.back().area = cell.area(ray);
        numbers_.push_back(k);
        ++count;
    }
    if (count == 0)
        return;
    is_wall_ = std::ranges::all_of(cells_, [](const MeasuredCell& cell) {
        return std::abs(cell.ray.normal.z()) <= upright_z;
    });
    rays_.emplace(std::span{rays}.first(count), std::span{lengths}.first(count));
}

void TileMeasure::take_rays()
{
    for (std::size_t k = 0; k < cells_.size(); ++k)
        if (const MownRay mown = (*rays_)[static_cast<int>(k)]; mown.sweep >= 0)
            cells_[k].left = mown;
    for (MeasuredCell& cell : cells_)
        cell.is_outer = is_outer(cell.ray);
}

// By the sweep that made it, and by `others` if there are any; never more than the stock
// holds.
double TileMeasure::most_left(const MeasuredCell& cell,
                              std::span<const std::int32_t> others) const
{
    if (cell.is_outer)
        return 0;
    const double in_stock = cell.in_stock.left + cell.reach * (1 + cell.in_stock.slope);
    return std::min(in_stock, most_left_by(cell, others));
}

double TileMeasure::most_left_by(const MeasuredCell& cell,
                                 std::span<const std::int32_t> others) const
{
    if (cell.left.sweep < 0)
        return most_left_by_slope(cell, Cutter::flat(1));
    const double by_slope = most_left_by_slope(cell, cutter_of(cell));
    if (others.empty() && !cutter_of(cell).is_flat())
        return by_slope;
    const std::int32_t own[] = {cell.left.sweep};
    return std::min(by_slope, most_left_by_corners(cell, measured_.charts, sweeps(),
                                                   others.empty() ? own : others));
}

// Where the deepest place of a sweep need not be one where its depth is stationary, or its
// depth at the middle tells nothing of it.
bool TileMeasure::needs_planes(const MeasuredCell& cell)
{
    if (sweeps().empty())
        return false;
    return corner_radius() == 0 || cell.reach > planes_share * corner_radius() ||
           (touches_side_ && measured_.charts.touches_side(cell.cell));
}

// Of one of the tile's own cells.
double TileMeasure::least_left(const MeasuredCell& cell)
{
    return needs_planes(cell) ? least_left_by_planes(cell, sweeps(), beneath())
                              : smooth_least(cell);
}

double TileMeasure::smooth_least(const MeasuredCell& cell)
{
    return sweeps().empty()
               ? cell.left.left
               : cell.left.left - hidden_gouge(cell, Cutter::ball(corner_radius()));
}

// The least of the sweeps that may gouge the tile, mm, or of all where none may: one with a
// sharp edge that stays well over the part hides nothing.
double TileMeasure::corner_radius()
{
    if (!corner_radius_) {
        corner_radius_ = measured_.tree.least_corner_radius();
        if (!measured_.tree.is_of_one_cutter() && rays_ && !beneath().empty()) {
            double least = std::numeric_limits<double>::infinity();
            for (const std::int32_t number : beneath())
                least = std::min(
                    least,
                    sweeps()[static_cast<std::size_t>(number)].cutter().corner_radius());
            corner_radius_ = least;
        }
    }
    return *corner_radius_;
}

}  // namespace endmill
