// SPDX-License-Identifier: GPL-3.0-or-later
// Refinement of TileMeasure. A cell whose bounds exceed the thresholds is halved into
// four; each quarter gets a ray of its own and closer bounds. The recursion ends if the
// bounds suffice, at `max_refine` levels, or when a tile has too many cells. In the last
// case the finest level that all cells can afford is found by bisection, because a
// depth-first order would otherwise give the first cells everything.
#include <algorithm>
#include <cmath>

#include "endmill/deviation/detail/half_space.h"
#include "endmill/deviation/detail/tile_measure.h"

namespace endmill {
namespace {

// Limit of the refined cells of a tile, some hundred times its own cells. Beyond it the
// bounds of the last complete level remain.
constexpr std::size_t most_refined_cells = 20'000;
// Up to this share of the corner radius, the sweeps that matter to a cell are recognised
// by the thickness that they leave at its middle. In a larger cell another sweep that
// passes beside the middle may be the lowest elsewhere. In a smaller one it could be only
// where it leaves nearly half the corner radius.
constexpr double local_share = 0.125;

}  // namespace

Extremes TileMeasure::refined(const RefinementThresholds& thresholds,
                              const DeviationLimits& known)
{
    known_ = known;
    double margin = 0;
    for (const MeasuredCell& cell : cells_) {
        if (thresholds.are_exceeded(most_left(cell, {}), least_left(cell)))
            margin = std::max(margin, owner_margin(cell));
    }
    if (!rays_)
        return {};
    const std::vector<std::int32_t> near = rays_->near_sweeps(measured_.tree, margin);
    Extremes found = refined_to(measured_.options.max_refine, thresholds, near);
    // The limit was reached, so the first cells were refined and the last were not.
    // Search for the finest level that is complete for all cells.
    int level = 0;
    for (int beyond = is_exhausted() ? measured_.options.max_refine : 1;
         beyond - level > 1;) {
        const int middle = (level + beyond) / 2;
        found.join(refined_to(middle, thresholds, near));
        (is_exhausted() ? beyond : level) = middle;
    }
    return found;
}

bool TileMeasure::is_exhausted() const
{
    return refined_cells_ >= most_refined_cells;
}

// Refines every cell down to at most this level.
Extremes TileMeasure::refined_to(int level, const RefinementThresholds& thresholds,
                                 std::span<const std::int32_t> near)
{
    Extremes found;
    refined_cells_ = 0;
    last_level_ = level;
    for (MeasuredCell& cell : cells_) {
        limit_thickness(cell, found);
        const bool by_planes = needs_planes(cell);
        const bool at_border =
            touches_side_ && measured_.charts.touches_border(cell.cell);
        refine(
            cell, thresholds,
            {0, at_border, near, by_planes ? gouging() : std::span<const std::int32_t>{}},
            found);
    }
    return found;
}

// Whether no place that lies `away` mm or more over the part (below 0: in the part) has
// its nearest place of the part on the cell. If another place is nearer to all points at
// this height over the cell, it is nearer to all higher points too.
// Source: paper/notes/deviation-bounds.md, eq. (c).
bool TileMeasure::has_no_foot(const MeasuredCell& cell, double away) const
{
    return has_no_foot(cell.ray, cell.reach, cell.curvature.absolute, away);
}

// The same for the part of a cell within `reach` of the foot of a ray.
bool TileMeasure::has_no_foot(const PartRay& ray, double reach, double curvature,
                              double away) const
{
    const double moves = reach * (1 + std::abs(away) * curvature);
    if (!(moves < std::abs(away)) || !std::isfinite(away))
        return false;
    std::optional<std::size_t> no_hint;
    return measured_.distance(ray.point + away * ray.normal, no_hint) + moves <
           std::abs(away);
}

// Whether no gouge of the depth -away or more has its foot where these sweeps clear the
// cell. A sweep that just touches an edge or a corner of the part clears a small part of the
// cells beside it, however large they are.
bool TileMeasure::clears_no_foot(const MeasuredCell& cell,
                                 std::span<const std::int32_t> sweep_numbers,
                                 double away) const
{
    return std::ranges::all_of(sweep_numbers, [&](std::int32_t number) {
        const auto cleared =
            part_cleared(cell, sweeps()[static_cast<std::size_t>(number)]);
        if (!cleared)
            return true;
        const auto ray = measured_.charts.ray(cell.cell.chart, cleared->at);
        return ray && has_no_foot(*ray, cleared->reach, cell.curvature.absolute, away);
    });
}

// Bounds the thickness on a cell and refines it if the bounds exceed the thresholds.
void TileMeasure::refine(const MeasuredCell& cell,
                         const RefinementThresholds& first_thresholds, const Depth& depth,
                         Extremes& found)
{
    found.take(cell);
    const bool by_planes = depth.by_planes || needs_planes(cell);
    const std::vector<std::int32_t> gouging =
        by_planes ? sweeps_on_cell(cell, sweeps(), depth.gouging)
                  : std::vector<std::int32_t>{};
    double most = most_left(cell, {});
    double least =
        by_planes ? least_left_by_planes(cell, sweeps(), gouging) : smooth_least(cell);
    // A maximum found in this tile may have settled more than those of the first rays.
    const RefinementThresholds thresholds =
        sharpened_thresholds(first_thresholds, found, limits());
    std::vector<std::int32_t> local;
    bool is_leaf = !thresholds.are_exceeded(most, least);
    if (!is_leaf) {
        local = local_sweeps(cell, sweeps(), depth.sweeps);
        if (most > thresholds.upper && !local.empty())
            most = most_left(cell, local);
        // This test takes time, so it runs only where the ray itself is too long, or
        // where planes give a poor bound.
        if (cell.cut.thickness > thresholds.upper && has_no_foot(cell, thresholds.upper))
            most = thresholds.upper;
        if (least < thresholds.lower &&
            (by_planes || cell.cut.thickness < thresholds.lower) &&
            (has_no_foot(cell, thresholds.lower) ||
             (by_planes && clears_no_foot(cell, gouging, thresholds.lower))))
            least = thresholds.lower;
        is_leaf = depth.level >= last_level_ || is_exhausted() ||
                  !thresholds.are_exceeded(most, least);
    }
    if (is_leaf) {
        found.bound(most, least);
        found.add_area(cell.value(), cell.area, limits());
        return;
    }
    // In a large cell the middle does not show whether another sweep or a sharp edge
    // crosses the cell. Then all sweeps are kept.
    const bool is_smooth =
        cell.cut.sweep >= 0 &&
        cell.reach <= local_share * measured_.tree.least_corner_radius();
    refine_quarters(
        cell, first_thresholds,
        {depth.level, depth.by_planes, is_smooth ? local : depth.sweeps, gouging}, found);
}

// Measures and refines the four quarters of a cell.
void TileMeasure::refine_quarters(const MeasuredCell& cell,
                                  const RefinementThresholds& first_thresholds,
                                  const Depth& depth, Extremes& found)
{
    const double quarter_area = cell.area / 4;
    const double gouged = found.gouge_area;
    const double uncut = found.uncut_area;
    for (const PartCell& quarter : cell.cell.quarters()) {
        // A strip of half a first cell along the border is not judged: there the cutter
        // reaches under an edge, and the depth along the normal means little. A finer
        // grid would judge a part of the strip, so its bounds count.
        const bool is_strip = depth.level == 0 && depth.by_planes &&
                              measured_.charts.runs_along_border(quarter);
        Extremes strip;
        Extremes& quarter_found = is_strip ? strip : found;
        ++refined_cells_;
        if (const auto ray = measured_.charts.ray(quarter.chart, quarter.centre())) {
            MeasuredCell finer = measured(quarter, *ray, depth.sweeps);
            limit_thickness(finer, quarter_found);
            refine(finer, first_thresholds,
                   {depth.level + 1, depth.by_planes, depth.sweeps, depth.gouging},
                   quarter_found);
        }
        if (is_strip) {
            found.bound(strip.upper, strip.lower);
            found.rays += strip.rays;
            found.add_area(cell.value(), quarter_area, limits());
        }
    }
    // A violation at the middle has at least the area of one quarter.
    if (-cell.value() > limits().tolerance && found.gouge_area == gouged)
        found.gouge_area += quarter_area;
    if (cell.value() > limits().scallop && found.uncut_area == uncut)
        found.uncut_area += quarter_area;
}

Extremes TileMeasure::halved(int times)
{
    Extremes found;
    if (!rays_)
        return found;
    double reach = 0;
    for (const MeasuredCell& cell : cells_)
        reach = std::max(reach, cell.reach);
    const std::vector<std::int32_t> near = rays_->near_sweeps(measured_.tree, reach);
    refined_cells_ = 0;
    for (const MeasuredCell& cell : cells_)
        halve(cell, times, near, found);
    return found;
}

// Halves a cell where a sweep comes near, and adds the rays that are cut.
void TileMeasure::halve(const MeasuredCell& cell, int times,
                        std::span<const std::int32_t> near, Extremes& found)
{
    const RayBounds around{.centre = cell.ray.point,
                           .upright = cell.ray.normal,
                           .beside = cell.reach,
                           .above = cell.reach * cell.reach * cell.curvature.absolute / 2,
                           .tilt = cell.reach * cell.curvature.absolute};
    std::vector<std::int32_t> here;
    for (const std::int32_t number : near) {
        const StraightSweep& sweep = sweeps()[static_cast<std::size_t>(number)];
        if (!around.is_out_of_reach(half_space_beyond(sweep, cell.ray.point), 0,
                                    std::max(0.0, cell.cut.thickness) + cell.reach))
            here.push_back(number);
    }
    if (times == 0 || here.empty() || is_exhausted())
        return;
    for (const PartCell& quarter : cell.cell.quarters()) {
        ++refined_cells_;
        const auto ray = measured_.charts.ray(quarter.chart, quarter.centre());
        if (!ray)
            continue;
        MeasuredCell finer = measured(quarter, *ray, here);
        if (finer.cut.sweep >= 0) {
            limit_thickness(finer, found);
            found.take(finer);
        }
        halve(finer, times - 1, here, found);
    }
}

// Measures a cell of the refinement by these sweeps alone.
MeasuredCell TileMeasure::measured(const PartCell& cell, const PartRay& ray,
                                   std::span<const std::int32_t> sweeps) const
{
    const CutRay in_stock = stock(ray);
    CutRay least = in_stock;
    for (const std::int32_t number : sweeps) {
        const StraightSweep& sweep =
            measured_.tree.sweeps()[static_cast<std::size_t>(number)];
        if (const auto cut = cut_ray(sweep, ray, least.thickness)) {
            least = *cut;
            least.sweep = number;
        }
    }
    MeasuredCell measured{.cell = cell,
                          .ray = ray,
                          .reach = cell.reach(ray),
                          .cut = least,
                          .curvature = curvature_,
                          .area = cell.area(ray),
                          .in_stock = in_stock};
    set_judged(measured);
    return measured;
}

}  // namespace endmill
