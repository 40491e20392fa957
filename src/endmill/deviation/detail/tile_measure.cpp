// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/tile_measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "endmill/core/tolerance.h"

namespace endmill {
namespace {

// Accuracy of a maximum as a share of its limit, if that is more than the slack.
constexpr double scallop_sharpness = 0.05;
constexpr double gouge_sharpness = 0.25;
// Up to this share of the corner radius a cell is small: its middle ray shows all but a
// bounded part of a gouge. On a larger cell the deepest place of a sweep may lie beside
// what the sweep clears of the ray at the middle.
constexpr double planes_share = 0.25;
// Tolerance of a unit normal's z for an upright wall; it allows for the rounding of
// coordinates in files.
constexpr double upright_z = 1e-3;

// Tiles are cut together if their distance is at most this many times their size.
constexpr double nearby_sizes = 8;

// Radius of a ball around the rays' points, mm.
double size_of(const RayBounds& bounds)
{
    return std::hypot(bounds.beside, bounds.above);
}

bool are_near(const RayBounds& one, const RayBounds& other)
{
    return (one.centre - other.centre).norm() <=
           nearby_sizes * std::min(size_of(one), size_of(other));
}

// Returns the greatest bound that changes nothing: the limit while it holds, or less if
// the accuracy of the maximum allows less.
double threshold(double found, double limit, double sharpness)
{
    const double raised = limit + verdict_slack;
    const double sharp = found + std::max(verdict_slack, sharpness * limit);
    return found <= raised ? std::min(sharp, raised) : sharp;
}

}  // namespace

// The curvatures at the corners of a group of tiles. Neighbours share corners, so each is
// computed once.
class TileMeasure::Curvatures {
public:
    explicit Curvatures(const PartCharts& charts) : charts_{charts} {}

    // Returns the greatest curvatures at the middle and the corners of the tile.
    PartCharts::CurvatureBounds of(const PartTile& tile)
    {
        const PartCell& whole = tile.whole;
        PartCharts::CurvatureBounds most = charts_.curvature(whole.chart, whole.centre());
        for (std::size_t k = 0; k < static_cast<std::size_t>(whole.corners); ++k) {
            const PartCharts::CurvatureBounds at = at_corner(whole.chart, whole.at[k]);
            most.convex = std::max(most.convex, at.convex);
            most.absolute = std::max(most.absolute, at.absolute);
        }
        return most;
    }

private:
    struct Corner {
        std::uint32_t chart;
        Eigen::Vector2d at;
        PartCharts::CurvatureBounds curvature;
    };

    PartCharts::CurvatureBounds at_corner(std::uint32_t chart, const Eigen::Vector2d& at)
    {
        const auto found = std::ranges::find_if(known_, [&](const Corner& corner) {
            return corner.at == at && corner.chart == chart;
        });
        if (found != known_.end())
            return found->curvature;
        known_.push_back({chart, at, charts_.curvature(chart, at)});
        return known_.back().curvature;
    }

    const PartCharts& charts_;
    std::vector<Corner> known_;
};

RefinementThresholds refinement_thresholds(double rest, double gouge,
                                           const DeviationLimits& limits)
{
    return {threshold(rest, limits.scallop, scallop_sharpness),
            -threshold(gouge, limits.tolerance, gouge_sharpness)};
}

RefinementThresholds sharpened_thresholds(const RefinementThresholds& thresholds,
                                          const Extremes& found,
                                          const DeviationLimits& limits)
{
    const RefinementThresholds here =
        refinement_thresholds(found.highest.left, -found.deepest.left, limits);
    return {std::max(thresholds.upper, here.upper),
            std::min(thresholds.lower, here.lower)};
}

PartCharts::CurvatureBounds greatest_curvature(const PartCharts& charts,
                                               const PartTile& tile)
{
    const PartCell& whole = tile.whole;
    PartCharts::CurvatureBounds most = charts.curvature(whole.chart, whole.centre());
    for (std::size_t k = 0; k < static_cast<std::size_t>(whole.corners); ++k) {
        const PartCharts::CurvatureBounds at = charts.curvature(whole.chart, whole.at[k]);
        most.convex = std::max(most.convex, at.convex);
        most.absolute = std::max(most.absolute, at.absolute);
    }
    return most;
}

bool is_skipped(const PartCharts& charts, std::uint32_t chart,
                const DeviationOptions& options)
{
    return !options.skipped_facets.empty() &&
           std::ranges::binary_search(options.skipped_facets, charts.source(chart));
}

bool is_beyond(double left, const DeviationLimits& limits)
{
    return left > limits.scallop || -left > limits.tolerance;
}

double limited_thickness(double left, const PartRay& ray, const PartDistance& distance,
                         std::optional<std::size_t>& hint)
{
    const double sign = left < 0 ? -1 : 1;
    const PartWay way{ray.point, sign * ray.normal, std::abs(left)};
    return sign * distance.free_ball(way, hint).length;
}

TileMeasure::TileMeasure(const Measured& measured, const PartTile& tile)
    : TileMeasure{measured, tile, Curvatures{measured.charts}.of(tile)}
{
    if (rays_)
        rays_->cut(measured_.tree);
    take_rays();
}

std::vector<TileMeasure> TileMeasure::measured_together(const Measured& measured,
                                                        std::span<const PartTile> tiles)
{
    std::vector<TileMeasure> measures;
    measures.reserve(tiles.size());
    Curvatures curvatures{measured.charts};
    for (const PartTile& tile : tiles)
        measures.push_back(TileMeasure{measured, tile, curvatures.of(tile)});
    // Tiles that are far apart have no sweeps in common.
    std::vector<CutRays*> near;
    for (TileMeasure& measure : measures) {
        if (!measure.rays_)
            continue;
        if (!near.empty() && !are_near(near.front()->bounds(), measure.rays_->bounds())) {
            CutRays::cut_together(near, measured.tree);
            near.clear();
        }
        near.push_back(&*measure.rays_);
    }
    CutRays::cut_together(near, measured.tree);
    for (TileMeasure& measure : measures)
        measure.take_rays();
    return measures;
}

// Lays out the rays without cutting them.
TileMeasure::TileMeasure(const Measured& measured, const PartTile& tile,
                         const PartCharts::CurvatureBounds& curvature)
    : measured_{measured},
      tile_{tile},
      curvature_{curvature},
      touches_side_{measured.charts.touches_side(tile.whole)}
{
    lay_out_rays();
}

// Bounds are computed without refinement.
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

// Whether the ray stands on an upright outer wall: there is no part above or below half a
// pitch beside it.
bool TileMeasure::is_outer(const PartRay& ray) const
{
    return is_wall_ && !measured_.distance.is_over_or_under(
                           ray.point + measured_.options.pitch / 2 * ray.normal);
}

// Whether the cutter can reach the ray's point. Rays without remaining material need no
// answer.
bool TileMeasure::is_inaccessible(const MeasuredCell& cell) const
{
    const auto& is_accessible = measured_.options.is_accessible;
    return is_accessible && cell.cut.thickness > reached_share * limits().scallop &&
           !is_accessible(cell.ray);
}

void TileMeasure::set_judged(MeasuredCell& cell) const
{
    cell.is_skipped = is_skipped(measured_.charts, cell.cell.chart, measured_.options);
    cell.is_outer = is_outer(cell.ray);
    cell.is_inaccessible = !cell.is_skipped && !cell.is_outer && is_inaccessible(cell);
}

// Returns the sweeps that may clear the part near the tile.
std::span<const std::int32_t> TileMeasure::gouging()
{
    if (!gouging_) {
        double reach = 0;
        for (const MeasuredCell& cell : cells_)
            reach = std::max(reach, cell.reach);
        gouging_ = rays_->gouging_sweeps(measured_.tree, reach,
                                         reach * reach * curvature_.absolute / 2);
    }
    return *gouging_;
}

// Makes the cells with a normal and their rays, with the material before any move.
void TileMeasure::lay_out_rays()
{
    const std::vector<PartCell> all = tile_cells(tile_);
    std::vector<PartRay> rays = tile_rays(measured_.charts, tile_, all);
    std::array<double, most_tile_cells> lengths;
    std::size_t count = 0;
    cells_.reserve(rays.size());
    numbers_.reserve(rays.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
        const PartRay& ray = rays[k];
        if (!has_normal(ray))
            continue;
        const CutRay in_stock = stock(ray);
        lengths[count] = in_stock.thickness;
        cells_.push_back({all[k], ray, all[k].reach(ray), in_stock, curvature_});
        cells_.back().in_stock = in_stock;
        cells_.back().area = all[k].area(ray);
        numbers_.push_back(static_cast<int>(k));
        if (count != k)
            rays[count] = ray;
        ++count;
    }
    if (count == 0)
        return;
    is_wall_ = std::ranges::all_of(cells_, [](const MeasuredCell& cell) {
        return std::abs(cell.ray.normal.z()) <= upright_z;
    });
    rays_.emplace(std::span{rays}.first(count), std::span{lengths}.first(count));
}

// Stores the cut rays in the cells.
void TileMeasure::take_rays()
{
    for (std::size_t k = 0; k < cells_.size(); ++k)
        if (const CutRay cut = (*rays_)[static_cast<int>(k)]; cut.sweep >= 0)
            cells_[k].cut = cut;
    for (MeasuredCell& cell : cells_)
        set_judged(cell);
}

// Upper bound of the thickness on a cell: by the sweep that made the surface at its
// middle, by `others` if there are any, and by the stock.
double TileMeasure::most_left(const MeasuredCell& cell,
                              std::span<const std::int32_t> others) const
{
    if (!cell.is_judged())
        return 0;
    const double in_stock =
        cell.in_stock.thickness + cell.reach * (1 + cell.in_stock.slope);
    return std::min(in_stock, most_left_by(cell, others));
}

double TileMeasure::most_left_by(const MeasuredCell& cell,
                                 std::span<const std::int32_t> others) const
{
    if (cell.cut.sweep < 0)
        return most_left_by_slope(cell, Cutter::flat(1));
    const double by_slope = most_left_by_slope(cell, cutter_of(cell));
    if (others.empty() && !cutter_of(cell).is_flat())
        return by_slope;
    const std::int32_t own[] = {cell.cut.sweep};
    return std::min(by_slope, most_left_by_corners(cell, measured_.charts, sweeps(),
                                                   others.empty() ? own : others));
}

// Whether bound (a) does not hold on the cell, because the deepest place of a sweep need
// not be stationary or is not visible at the middle.
bool TileMeasure::needs_planes(const MeasuredCell& cell)
{
    if (sweeps().empty())
        return false;
    return corner_radius() == 0 || cell.reach > planes_share * corner_radius() ||
           (touches_side_ && measured_.charts.touches_side(cell.cell));
}

// Lower bound of the thickness on one of the tile's own cells.
double TileMeasure::least_left(const MeasuredCell& cell)
{
    return needs_planes(cell) ? least_left_by_planes(cell, sweeps(), gouging())
                              : smooth_least(cell);
}

// The lower bound where the part is smooth and the corner round.
double TileMeasure::smooth_least(const MeasuredCell& cell)
{
    return sweeps().empty() ? cell.cut.thickness
                            : cell.cut.thickness - hidden_gouge(cell, corner_radius());
}

// Smallest corner radius in mm of the sweeps that may gouge the tile; of all sweeps if
// none may. A sharp-edged cutter that stays well above the part hides nothing.
double TileMeasure::corner_radius()
{
    if (!corner_radius_) {
        corner_radius_ = measured_.tree.least_corner_radius();
        if (!measured_.tree.is_of_one_cutter() && rays_ && !gouging().empty()) {
            double least = std::numeric_limits<double>::infinity();
            for (const std::int32_t number : gouging())
                least = std::min(
                    least,
                    sweeps()[static_cast<std::size_t>(number)].cutter().corner_radius());
            corner_radius_ = least;
        }
    }
    return *corner_radius_;
}

}  // namespace endmill
