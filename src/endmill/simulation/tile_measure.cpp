// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/simulation/tile_measure.h"

#include <array>

namespace endmill {
namespace {

// Shares of the limits to within which a maximum is sought, if that is more than the slack.
constexpr double scallop_sharpness = 0.05;
constexpr double gouge_sharpness = 0.25;
// Cells that the refinement of one tile may come to: some hundred times its own. If they
// do not do, the doubt of the last level that they do for stays.
constexpr std::size_t most_refined_cells = 20'000;
// Of the corner radius: the sweeps that matter to a cell of this reach are known by what
// they leave at its middle. In a larger one others, which pass beside the middle, may be
// the lowest elsewhere; in this one only where they leave nearly half the radius.
constexpr double local_share = 0.125;

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
    const double away = distance(ray.point + left * ray.normal, hint);
    return std::clamp(left, -away, away);
}

TileMeasure::TileMeasure(const Measured& measured, const PartTile& tile)
    : measured_{measured},
      tile_{tile}
{
    const auto corners = static_cast<std::size_t>(tile.whole.corners);
    bend_ = measured_.charts.bend(tile.whole.chart, tile.whole.centre());
    for (std::size_t k = 0; k < corners; ++k) {
        const PartCharts::Bend bend =
            measured_.charts.bend(tile.whole.chart, tile.whole.at[k]);
        bend_.convex = std::max(bend_.convex, bend.convex);
        bend_.any = std::max(bend_.any, bend.any);
    }
    measure();
}

Extremes TileMeasure::extremes() const
{
    Extremes found;
    for (const MeasuredCell& cell : cells_) {
        found.take(cell);
        found.bound(cell.left.left, most_left(cell, {}), least_left(cell));
    }
    return found;
}

Extremes TileMeasure::refined(const Doubt& doubt)
{
    double margin = 0;
    for (const MeasuredCell& cell : cells_)
        if (doubt.holds(most_left(cell, {}), least_left(cell)))
            margin = std::max(margin, owner_margin(cell));
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
    for (const MeasuredCell& cell : cells_)
        refine(cell, doubt, {0, near}, found);
    return found;
}

void TileMeasure::measure()
{
    std::array<PartRay, most_tile_cells> rays;
    std::array<double, most_tile_cells> lengths;
    std::size_t count = 0;
    for (int k = 0; k < tile_.cells(); ++k) {
        const PartCell cell = tile_.cell(k);
        const auto ray = measured_.charts.ray(cell.chart, cell.centre());
        if (!ray)
            continue;
        rays[count] = *ray;
        const MownRay in_stock = stock(*ray);
        lengths[count] = in_stock.left;
        cells_.push_back({cell, *ray, cell.reach(*ray), in_stock, bend_});
        numbers_.push_back(k);
        ++count;
    }
    if (count == 0)
        return;
    rays_.emplace(std::span{rays}.first(count), std::span{lengths}.first(count));
    rays_->mow(measured_.tree);
    for (std::size_t k = 0; k < count; ++k)
        if (const MownRay& mown = (*rays_)[static_cast<int>(k)]; mown.sweep >= 0)
            cells_[k].left = mown;
}

// By the sweep that made it, and by `others` if there are any; never more than the stock
// holds.
double TileMeasure::most_left(const MeasuredCell& cell,
                              std::span<const std::int32_t> others) const
{
    const MownRay full = stock(cell.ray);
    const double in_stock = full.left + cell.reach * (1 + full.slope);
    return std::min(in_stock, most_left_by(cell, others));
}

double TileMeasure::most_left_by(const MeasuredCell& cell,
                                 std::span<const std::int32_t> others) const
{
    if (cell.left.sweep < 0)
        return most_left_by_slope(cell, Cutter::flat(1));
    const double by_slope = most_left_by_slope(cell, cutter());
    if (others.empty() && !cutter().is_flat())
        return by_slope;
    const std::int32_t own[] = {cell.left.sweep};
    return std::min(by_slope,
                    most_left_by_corners(cell, measured_.charts, measured_.tree.sweeps(),
                                         others.empty() ? own : others));
}

double TileMeasure::least_left(const MeasuredCell& cell) const
{
    if (cell.left.sweep < 0)
        return cell.left.left;
    return cell.left.left - hidden_gouge(cell, cutter());
}

Doubt TileMeasure::sharpened(const Doubt& doubt, const Extremes& found) const
{
    const Doubt here =
        doubt_beyond(found.highest.left, -found.deepest.left, measured_.options.limits);
    return {std::max(doubt.upper, here.upper), std::min(doubt.lower, here.lower)};
}

void TileMeasure::refine(const MeasuredCell& cell, const Doubt& first_doubt,
                         const Depth& depth, Extremes& found)
{
    found.take(cell);
    double most = most_left(cell, {});
    const double least = least_left(cell);
    // What has been found here meanwhile may have settled more than the first rays.
    const Doubt doubt = sharpened(first_doubt, found);
    if (!doubt.holds(most, least)) {
        found.bound(cell.left.left, most, least);
        return;
    }
    const std::vector<std::int32_t> local =
        local_sweeps(cell, measured_.tree.sweeps(), depth.sweeps);
    if (most > doubt.upper && !local.empty())
        most = most_left(cell, local);
    const bool is_last = depth.level >= last_level_ || is_exhausted();
    if (is_last || !doubt.holds(most, least)) {
        found.bound(cell.left.left, most, least);
        return;
    }
    // Whether a sharp edge, or any, passes through the cell the middle does not tell.
    const bool is_smooth =
        cell.left.sweep >= 0 && cell.reach <= local_share * cutter().corner_radius();
    const std::span<const std::int32_t> inherited = is_smooth ? local : depth.sweeps;
    for (const PartCell& quarter : cell.cell.quarters()) {
        // A strip of half a first cell along the border is not judged: there the cutter
        // reaches under an edge, and depth along the normal tells little.
        if (depth.level == 0 && measured_.charts.touches_border(quarter))
            continue;
        ++refined_cells_;
        if (const auto ray = measured_.charts.ray(quarter.chart, quarter.centre()))
            refine(measured(quarter, *ray, inherited), first_doubt,
                   {depth.level + 1, inherited}, found);
    }
}

MeasuredCell TileMeasure::measured(const PartCell& cell, const PartRay& ray,
                                   std::span<const std::int32_t> sweeps) const
{
    MownRay least = stock(ray);
    for (const std::int32_t number : sweeps) {
        const StraightSweep& sweep =
            measured_.tree.sweeps()[static_cast<std::size_t>(number)];
        if (const auto left = mown(sweep, ray, least.left)) {
            least = *left;
            least.sweep = number;
        }
    }
    MeasuredCell found{cell, ray, cell.reach(ray), least, bend_};
    if (is_beyond(found.left.left, measured_.options.limits)) {
        std::optional<std::size_t> no_hint;
        found.left.left = shortened(found.left.left, ray, measured_.distance, no_hint);
    }
    return found;
}

}  // namespace endmill
