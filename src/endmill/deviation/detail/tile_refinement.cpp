// SPDX-License-Identifier: GPL-3.0-or-later
// What TileMeasure does with cells in doubt: it halves them.
#include <algorithm>
#include <cmath>

#include "endmill/deviation/detail/half_space.h"
#include "endmill/deviation/detail/tile_measure.h"

namespace endmill {
namespace {

// Cells that the refinement of one tile may come to: some hundred times its own. If they
// do not do, the doubt of the last level that they do for stays.
constexpr std::size_t most_refined_cells = 20'000;
// Of the corner radius: the sweeps that matter to a cell of this reach are known by what
// they leave at its middle. In a larger one others, which pass beside the middle, may be
// the lowest elsewhere; in this one only where they leave nearly half the radius.
constexpr double local_share = 0.125;

}  // namespace

Extremes TileMeasure::refined(const Doubt& doubt, const DeviationLimits& known)
{
    known_ = known;
    double margin = 0;
    for (const MeasuredCell& cell : cells_) {
        if (doubt.holds(most_left(cell, {}), least_left(cell)))
            margin = std::max(margin, owner_margin(cell));
    }
    if (!rays_)
        return {};
    const std::vector<std::int32_t> near = rays_->near_sweeps(measured_.tree, margin);
    Extremes found = refined_to(measured_.options.max_refine, doubt, near);
    // Where the first cells have taken all there is, the others had nothing: the finest
    // level that does for all of them tells more.
    int level = 0;
    for (int beyond = is_exhausted() ? measured_.options.max_refine : 1;
         beyond - level > 1;) {
        const int middle = (level + beyond) / 2;
        found.join(refined_to(middle, doubt, near));
        (is_exhausted() ? beyond : level) = middle;
    }
    return found;
}

bool TileMeasure::is_exhausted() const
{
    return refined_cells_ >= most_refined_cells;
}

// Every doubtful cell halved so many times at most.
Extremes TileMeasure::refined_to(int level, const Doubt& doubt,
                                 std::span<const std::int32_t> near)
{
    Extremes found;
    refined_cells_ = 0;
    last_level_ = level;
    for (MeasuredCell& cell : cells_) {
        find_nearer(cell, found);
        const bool by_planes = needs_planes(cell);
        const bool at_border =
            touches_side_ && measured_.charts.touches_border(cell.cell);
        refine(
            cell, doubt,
            {0, at_border, near, by_planes ? beneath() : std::span<const std::int32_t>{}},
            found);
    }
    return found;
}

// Whether no place `away` mm or more over the part (below 0: in it) has its nearest place of
// the part on the cell: another is nearer to all that stand so far over the cell, and so to
// all that stand higher.
bool TileMeasure::has_no_foot(const MeasuredCell& cell, double away) const
{
    const double moves = cell.reach * (1 + std::abs(away) * cell.bend.any);
    if (!(moves < std::abs(away)) || !std::isfinite(away))
        return false;
    std::optional<std::size_t> no_hint;
    return measured_.distance(cell.ray.point + away * cell.ray.normal, no_hint) + moves <
           std::abs(away);
}

Doubt TileMeasure::sharpened(const Doubt& doubt, const Extremes& found) const
{
    const Doubt here = doubt_beyond(found.highest.left, -found.deepest.left, limits());
    return {std::max(doubt.upper, here.upper), std::min(doubt.lower, here.lower)};
}

void TileMeasure::refine(const MeasuredCell& cell, const Doubt& first_doubt,
                         const Depth& depth, Extremes& found)
{
    found.take(cell);
    const bool by_planes = depth.by_planes || needs_planes(cell);
    const std::vector<std::int32_t> beneath =
        by_planes ? sweeps_on_cell(cell, sweeps(), depth.beneath)
                  : std::vector<std::int32_t>{};
    double most = most_left(cell, {});
    double least =
        by_planes ? least_left_by_planes(cell, sweeps(), beneath) : smooth_least(cell);
    // What has been found here meanwhile may have settled more than the first rays.
    const Doubt doubt = sharpened(first_doubt, found);
    std::vector<std::int32_t> local;
    bool is_leaf = !doubt.holds(most, least);
    if (!is_leaf) {
        local = local_sweeps(cell, sweeps(), depth.sweeps);
        if (most > doubt.upper && !local.empty())
            most = most_left(cell, local);
        // Only where the ray itself is too long, or a plane tells little: it takes time.
        if (cell.left.left > doubt.upper && has_no_foot(cell, doubt.upper))
            most = doubt.upper;
        if (least < doubt.lower && (by_planes || cell.left.left < doubt.lower) &&
            has_no_foot(cell, doubt.lower))
            least = doubt.lower;
        is_leaf =
            depth.level >= last_level_ || is_exhausted() || !doubt.holds(most, least);
    }
    if (is_leaf) {
        found.bound(most, least);
        found.add_area(cell.value(), cell.area, limits());
        return;
    }
    // Whether a sharp edge, or any, passes through the cell the middle does not tell.
    const bool is_smooth =
        cell.left.sweep >= 0 &&
        cell.reach <= local_share * measured_.tree.least_corner_radius();
    refine_quarters(
        cell, first_doubt,
        {depth.level, depth.by_planes, is_smooth ? local : depth.sweeps, beneath}, found);
}

void TileMeasure::refine_quarters(const MeasuredCell& cell, const Doubt& first_doubt,
                                  const Depth& depth, Extremes& found)
{
    const double quarter_area = cell.area / 4;
    const double gouged = found.gouge_area;
    const double uncut = found.uncut_area;
    for (const PartCell& quarter : cell.cell.quarters()) {
        // A strip of half a first cell along the border is not judged: there the cutter
        // reaches under an edge, and depth along the normal tells little. But a finer
        // grid judges some of it, so that what is there leaves the verdict open.
        const bool is_strip = depth.level == 0 && depth.by_planes &&
                              measured_.charts.runs_along_border(quarter);
        Extremes strip;
        Extremes& quarter_found = is_strip ? strip : found;
        ++refined_cells_;
        if (const auto ray = measured_.charts.ray(quarter.chart, quarter.centre())) {
            MeasuredCell finer = measured(quarter, *ray, depth.sweeps);
            find_nearer(finer, quarter_found);
            refine(finer, first_doubt,
                   {depth.level + 1, depth.by_planes, depth.sweeps, depth.beneath},
                   quarter_found);
        }
        if (is_strip) {
            found.bound(strip.upper, strip.lower);
            found.rays += strip.rays;
            found.add_area(cell.value(), quarter_area, limits());
        }
    }
    // What the middle has is found, however little there is of it.
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

void TileMeasure::halve(const MeasuredCell& cell, int times,
                        std::span<const std::int32_t> near, Extremes& found)
{
    const RayBundle around{.centre = cell.ray.point,
                           .upright = cell.ray.normal,
                           .beside = cell.reach,
                           .above = cell.reach * cell.reach * cell.bend.any / 2,
                           .tilt = cell.reach * cell.bend.any};
    std::vector<std::int32_t> here;
    for (const std::int32_t number : near) {
        const StraightSweep& sweep = sweeps()[static_cast<std::size_t>(number)];
        if (!around.is_out_of_reach(half_space_beyond(sweep, cell.ray.point), 0,
                                    std::max(0.0, cell.left.left) + cell.reach))
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
        if (finer.left.sweep >= 0) {
            find_nearer(finer, found);
            found.take(finer);
        }
        halve(finer, times - 1, here, found);
    }
}

MeasuredCell TileMeasure::measured(const PartCell& cell, const PartRay& ray,
                                   std::span<const std::int32_t> sweeps) const
{
    const MownRay in_stock = stock(ray);
    MownRay least = in_stock;
    for (const std::int32_t number : sweeps) {
        const StraightSweep& sweep =
            measured_.tree.sweeps()[static_cast<std::size_t>(number)];
        if (const auto left = mown(sweep, ray, least.left)) {
            least = *left;
            least.sweep = number;
        }
    }
    return {.cell = cell,
            .ray = ray,
            .reach = cell.reach(ray),
            .left = least,
            .bend = bend_,
            .is_outer = is_outer(ray),
            .area = cell.area(ray),
            .in_stock = in_stock};
}

}  // namespace endmill
