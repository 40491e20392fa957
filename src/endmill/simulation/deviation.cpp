// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/simulation/deviation.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>

#include "endmill/core/error.h"
#include "endmill/core/numbers.h"
#include "endmill/core/parallel.h"
#include "endmill/simulation/cell_bounds.h"
#include "endmill/simulation/part_distance.h"

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
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
// Of the narrower limit, and of the pitch at least: how closely the distance from the part
// is known where a limit is broken.
constexpr double distance_share = 0.25;
constexpr double finest_distance_share = 0.1;

// What has been found on some cells.
struct Extremes {
    DeviationPlace highest{-infinite};
    DeviationPlace deepest{infinite};
    double upper = -infinite;  // no rest is higher
    double lower = infinite;   // no gouge is deeper
    double above = 0;  // most that a cell may have more than at its middle, and less
    double below = 0;
    bool is_cut = false;
    std::size_t rays = 0;

    void take(const MeasuredCell& cell)
    {
        ++rays;
        is_cut = is_cut || cell.left.sweep >= 0;
        const DeviationPlace place{cell.left.left, cell.ray, cell.cell.chart,
                                   cell.cell.centre(), cell.left.sweep};
        if (place.left > highest.left)
            highest = place;
        if (place.left < deepest.left)
            deepest = place;
    }
    void bound(double left, double most, double least)
    {
        upper = std::max(upper, most);
        lower = std::min(lower, least);
        above = std::max(above, most - left);
        below = std::max(below, left - least);
    }
    // Of the same cells once more: what has been found holds for both, and the closer
    // bounds.
    void join(const Extremes& other)
    {
        const double most = std::min(upper, other.upper);
        const double least = std::max(lower, other.lower);
        merge(other);
        upper = std::max(most, highest.left);
        lower = std::min(least, deepest.left);
    }
    // Of equal ones the first stays, so the order of the tiles decides.
    void merge(const Extremes& other)
    {
        if (other.highest.left > highest.left)
            highest = other.highest;
        if (other.deepest.left < deepest.left)
            deepest = other.deepest;
        upper = std::max(upper, other.upper);
        lower = std::min(lower, other.lower);
        is_cut = is_cut || other.is_cut;
        rays += other.rays;
    }
};

// Bounds beyond which a cell has to be looked at more closely, and how closely at most.
struct Doubt {
    double upper;
    double lower;
    int halvings;

    bool holds(double most, double least) const { return most > upper || least < lower; }
};

// The most that a maximum may turn out higher without changing anything.
double threshold(double found, double limit, double sharpness)
{
    const double raised = limit + verdict_slack;
    const double sharp = found + std::max(verdict_slack, sharpness * limit);
    return found <= raised ? std::min(sharp, raised) : sharp;
}

// Close enough for what the distance is for, and no finer than the cells.
double distance_tolerance(const DeviationOptions& options)
{
    return std::max(
        distance_share * std::min(options.limits.scallop, options.limits.tolerance),
        finest_distance_share * options.pitch);
}

// What is measured, and how.
struct Measured {
    const PartCharts& charts;
    const SweepTree& tree;
    const DeviationOptions& options;
    const PartDistance& distance;
};

// Whether a limit is broken there.
bool is_beyond(double left, const DeviationLimits& limits)
{
    return left > limits.scallop || -left > limits.tolerance;
}

// The distance from the part of the place where the material ends, if that is less than
// `left`, with its sign.
double shortened(double left, const PartRay& ray, const PartDistance& distance,
                 std::optional<std::size_t>& hint)
{
    const double away = distance(ray.point + left * ray.normal, hint);
    return std::clamp(left, -away, away);
}

class TileMeasure {
public:
    TileMeasure(const Measured& measured, const PartTile& tile)
        : charts_{measured.charts},
          tree_{measured.tree},
          options_{measured.options},
          tile_{tile},
          distance_{measured.distance}
    {
        const auto corners = static_cast<std::size_t>(tile.whole.corners);
        bend_ = charts_.bend(tile.whole.chart, tile.whole.centre());
        for (std::size_t k = 0; k < corners; ++k) {
            const PartCharts::Bend bend =
                charts_.bend(tile.whole.chart, tile.whole.at[k]);
            bend_.convex = std::max(bend_.convex, bend.convex);
            bend_.any = std::max(bend_.any, bend.any);
        }
        measure();
    }

    // The cells of the tile that have a normal, and their numbers in it.
    std::span<const MeasuredCell> cells() const { return cells_; }
    std::span<const int> numbers() const { return numbers_; }

    Extremes extremes() const
    {
        Extremes found;
        for (const MeasuredCell& cell : cells_) {
            found.take(cell);
            found.bound(cell.left.left, most_left(cell, {}), least_left(cell));
        }
        return found;
    }

    // The same with every doubtful cell refined.
    Extremes refined(const Doubt& doubt)
    {
        double margin = 0;
        for (const MeasuredCell& cell : cells_)
            if (doubt.holds(most_left(cell, {}), least_left(cell)))
                margin = std::max(margin, owner_margin(cell));
        const std::vector<std::int32_t> near = rays_->near_sweeps(tree_, margin);
        Extremes found = refined_to(options_.max_refine, doubt, near);
        // Where the first cells have taken all there is, the others had nothing: the finest
        // level that does for all of them tells more.
        int level = 0;
        for (int beyond = is_exhausted() ? options_.max_refine : 1; beyond - level > 1;) {
            const int middle = (level + beyond) / 2;
            found.join(refined_to(middle, doubt, near));
            (is_exhausted() ? beyond : level) = middle;
        }
        return found;
    }

private:
    bool is_exhausted() const { return refined_cells_ >= most_refined_cells; }

    // Every doubtful cell halved so many times at most.
    Extremes refined_to(int level, const Doubt& doubt, std::span<const std::int32_t> near)
    {
        Extremes found;
        refined_cells_ = 0;
        last_level_ = level;
        for (const MeasuredCell& cell : cells_)
            refine(cell, doubt, {0, near}, found);
        return found;
    }

    void measure()
    {
        std::array<PartRay, most_tile_cells> rays;
        std::array<double, most_tile_cells> lengths;
        std::size_t count = 0;
        for (int k = 0; k < tile_.cells(); ++k) {
            const PartCell cell = tile_.cell(k);
            const auto ray = charts_.ray(cell.chart, cell.centre());
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
        rays_->mow(tree_);
        for (std::size_t k = 0; k < count; ++k)
            if (const MownRay& mown = (*rays_)[static_cast<int>(k)]; mown.sweep >= 0)
                cells_[k].left = mown;
    }

    MownRay stock(const PartRay& ray) const
    {
        return options_.stock ? options_.stock(ray) : MownRay{infinite, 0, -1};
    }

    const Cutter& cutter() const { return tree_.sweeps().front().cutter(); }

    // By the sweep that made it, and by `others` if there are any; never more than the
    // stock holds.
    double most_left(const MeasuredCell& cell, std::span<const std::int32_t> others) const
    {
        const MownRay full = stock(cell.ray);
        const double in_stock = full.left + cell.reach * (1 + full.slope);
        return std::min(in_stock, most_left_by(cell, others));
    }

    double most_left_by(const MeasuredCell& cell,
                        std::span<const std::int32_t> others) const
    {
        if (cell.left.sweep < 0)
            return most_left_by_slope(cell, Cutter::flat(1));
        const double by_slope = most_left_by_slope(cell, cutter());
        if (others.empty() && !cutter().is_flat())
            return by_slope;
        const std::int32_t own[] = {cell.left.sweep};
        return std::min(by_slope, most_left_by_corners(cell, charts_, tree_.sweeps(),
                                                       others.empty() ? own : others));
    }

    double least_left(const MeasuredCell& cell) const
    {
        if (cell.left.sweep < 0)
            return cell.left.left;
        return cell.left.left - hidden_gouge(cell, cutter());
    }

    Doubt sharpened(const Doubt& doubt, const Extremes& found) const
    {
        const DeviationLimits& limits = options_.limits;
        return {std::max(doubt.upper, threshold(found.highest.left, limits.scallop,
                                                scallop_sharpness)),
                std::min(doubt.lower, -threshold(-found.deepest.left, limits.tolerance,
                                                 gouge_sharpness)),
                doubt.halvings};
    }

    // How far a cell has been halved, and the sweeps that may matter to it.
    struct Depth {
        int level;
        std::span<const std::int32_t> sweeps;
    };

    void refine(const MeasuredCell& cell, const Doubt& first_doubt, const Depth& depth,
                Extremes& found)
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
            local_sweeps(cell, tree_.sweeps(), depth.sweeps);
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
            ++refined_cells_;
            if (const auto ray = charts_.ray(quarter.chart, quarter.centre()))
                refine(measured(quarter, *ray, inherited), first_doubt,
                       {depth.level + 1, inherited}, found);
        }
    }

    MeasuredCell measured(const PartCell& cell, const PartRay& ray,
                          std::span<const std::int32_t> sweeps) const
    {
        MownRay least = stock(ray);
        for (const std::int32_t number : sweeps) {
            const StraightSweep& sweep = tree_.sweeps()[static_cast<std::size_t>(number)];
            if (const auto left = mown(sweep, ray, least.left)) {
                least = *left;
                least.sweep = number;
            }
        }
        MeasuredCell found{cell, ray, cell.reach(ray), least, bend_};
        if (is_beyond(found.left.left, options_.limits)) {
            std::optional<std::size_t> no_hint;
            found.left.left = shortened(found.left.left, ray, distance_, no_hint);
        }
        return found;
    }

    const PartCharts& charts_;
    const SweepTree& tree_;
    const DeviationOptions& options_;
    const PartTile& tile_;
    const PartDistance& distance_;
    PartCharts::Bend bend_;
    std::vector<MeasuredCell> cells_;
    std::vector<int> numbers_;
    std::optional<MownRays> rays_;
    std::size_t refined_cells_ = 0;
    int last_level_ = 0;
};

// The value that 99 % of the area does not reach, from a histogram over the leading bits
// of each value, that is in steps of 1/2048 of it.
double area_quantile(std::span<const float> values, std::span<const float> areas,
                     double share)
{
    constexpr int dropped_bits = 12;
    std::vector<double> bins(std::size_t{1} << (32 - 1 - dropped_bits));
    double total = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const float value = std::max(values[i], 0.0F);
        bins[std::bit_cast<std::uint32_t>(value) >> dropped_bits] += areas[i];
        total += areas[i];
    }
    double sum = 0;
    for (std::uint32_t bin = 0; bin < bins.size(); ++bin) {
        sum += bins[bin];
        if (bins[bin] > 0 && sum >= share * total)
            return std::bit_cast<float>(bin << dropped_bits);
    }
    return 0;
}

void add_areas(Deviation& deviation, const DeviationLimits& limits)
{
    double rest = 0;
    for (std::size_t i = 0; i < deviation.left.size(); ++i) {
        const double left = deviation.left[i];
        const double area = deviation.area[i];
        deviation.area_mm2 += area;
        rest += area * std::max(left, 0.0);
        if (-left > limits.tolerance)
            deviation.gouge_area_mm2 += area;
        if (left > limits.scallop)
            deviation.uncut_area_mm2 += area;
    }
    if (deviation.area_mm2 > 0)
        deviation.mean_scallop_mm = rest / deviation.area_mm2;
    deviation.p99_scallop_mm = area_quantile(deviation.left, deviation.area, 0.99);
}

void add_extremes(Deviation& deviation, const Extremes& found)
{
    deviation.rays = found.rays;
    deviation.is_cut = found.is_cut;
    deviation.max_scallop_mm = std::max(0.0, found.highest.left);
    deviation.max_gouge_mm = std::max(0.0, -found.deepest.left);
    if (found.highest.left > 0)
        deviation.highest = found.highest;
    if (found.deepest.left < 0)
        deviation.deepest = found.deepest;
    deviation.scallop_bound_mm = std::max(0.0, found.upper - deviation.max_scallop_mm);
    deviation.gouge_bound_mm = std::max(0.0, -found.lower - deviation.max_gouge_mm);
}

void check(const DeviationOptions& options)
{
    require(options.limits.tolerance > 0 && std::isfinite(options.limits.tolerance),
            "measure_deviation: need 0 < tolerance");
    require(options.limits.scallop > 0 && std::isfinite(options.limits.scallop),
            "measure_deviation: need 0 < scallop");
    require(0 <= options.max_refine && options.max_refine <= 20,
            "measure_deviation: need 0 <= max_refine <= 20");
}

// Tells how far the work is, whichever thread does it.
class Progress {
public:
    Progress(const DeviationOptions& options, std::size_t steps)
        : options_{options},
          steps_{steps}
    {
    }
    void step()
    {
        const std::size_t done = ++done_;
        if (options_.progress && done % 256 == 0)
            options_.progress(static_cast<double>(done) / static_cast<double>(steps_));
    }

private:
    const DeviationOptions& options_;
    std::size_t steps_;
    std::atomic<std::size_t> done_ = 0;
};

// The whole part, tile by tile: once for the first rays, then for what is in doubt.
class Measurement {
public:
    explicit Measurement(const Measured& measured)
        : measured_{measured},
          limits_{measured.options.limits}
    {
    }

    Deviation run()
    {
        const DeviationOptions& options = measured_.options;
        deviation_.pitch_mm = options.pitch;
        deviation_.tiles =
            part_tiles(measured_.charts, options.pitch, options.most_cells);
        const std::size_t cells = cell_count(deviation_.tiles);
        deviation_.left.assign(cells, 0);
        deviation_.area.assign(cells, 0);
        sweeps_.assign(cells, -1);
        of_tile_.resize(deviation_.tiles.size());
        Progress progress{options, 2 * of_tile_.size()};
        for_tiles(progress, [&](std::size_t i) { measure(i); });
        Extremes found = merged();
        if (is_beyond(found)) {
            for_tiles(progress, [&](std::size_t i) {
                if (is_beyond(of_tile_[i]))
                    shorten(i);
            });
            found = merged();
        }
        refine(found, progress);
        add_extremes(deviation_, merged());
        add_areas(deviation_, limits_);
        return std::move(deviation_);
    }

private:
    template <typename Body>
    void for_tiles(Progress& progress, const Body& body)
    {
        parallel_for(of_tile_.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                body(i);
                progress.step();
            }
        });
    }

    bool is_beyond(const Extremes& some) const
    {
        return endmill::is_beyond(some.highest.left, limits_) ||
               endmill::is_beyond(some.deepest.left, limits_);
    }

    // Where a limit is broken in a tile, the distance from the part counts.
    void shorten(std::size_t number)
    {
        const PartTile& tile = deviation_.tiles[number];
        Extremes& found = of_tile_[number];
        found.highest.left = -infinite;
        found.deepest.left = infinite;
        std::optional<std::size_t> hint;
        for (int k = 0; k < tile.cells(); ++k) {
            const std::size_t at = tile.first + static_cast<std::size_t>(k);
            const PartCell cell = tile.cell(k);
            const auto ray = measured_.charts.ray(cell.chart, cell.centre());
            if (!ray)
                continue;
            double left = deviation_.left[at];
            if (endmill::is_beyond(left, limits_)) {
                left = shortened(left, *ray, measured_.distance, hint);
                deviation_.left[at] = static_cast<float>(left);
            }
            const DeviationPlace place{left, *ray, cell.chart, cell.centre(),
                                       sweeps_[at]};
            if (left > found.highest.left)
                found.highest = place;
            if (left < found.deepest.left)
                found.deepest = place;
        }
        found.upper = std::min(found.upper, found.highest.left + found.above);
        found.lower = std::max(found.lower, found.deepest.left - found.below);
    }

    void measure(std::size_t number)
    {
        const PartTile& tile = deviation_.tiles[number];
        const TileMeasure measure{measured_, tile};
        for (std::size_t k = 0; k < measure.cells().size(); ++k) {
            const MeasuredCell& cell = measure.cells()[k];
            const std::size_t at =
                tile.first + static_cast<std::size_t>(measure.numbers()[k]);
            deviation_.left[at] = static_cast<float>(cell.left.left);
            deviation_.area[at] = static_cast<float>(cell.cell.area(cell.ray));
            sweeps_[at] = cell.left.sweep;
        }
        of_tile_[number] = measure.extremes();
    }

    // What is refined follows from what all first rays have found, so that it does not
    // hang on which thread was first.
    void refine(const Extremes& found, Progress& progress)
    {
        const double rest = std::max(0.0, found.highest.left);
        const double gouge = std::max(0.0, -found.deepest.left);
        const bool is_known = rest > limits_.scallop + verdict_slack ||
                              gouge > limits_.tolerance + verdict_slack;
        if (is_known)
            return;
        const int halvings = measured_.options.max_refine;
        const Doubt doubt{threshold(rest, limits_.scallop, scallop_sharpness),
                          -threshold(gouge, limits_.tolerance, gouge_sharpness),
                          halvings};
        for_tiles(progress, [&](std::size_t i) {
            if (doubt.holds(of_tile_[i].upper, of_tile_[i].lower))
                of_tile_[i] = TileMeasure{measured_, deviation_.tiles[i]}.refined(doubt);
        });
    }

    Extremes merged() const
    {
        Extremes found;
        for (const Extremes& some : of_tile_)
            found.merge(some);
        return found;
    }

    Measured measured_;
    DeviationLimits limits_;
    Deviation deviation_;
    std::vector<Extremes> of_tile_;
    std::vector<std::int32_t> sweeps_;  // of each cell
};

}  // namespace

Deviation measure_deviation(const PartCharts& charts, const SweepTree& tree,
                            const DeviationOptions& options)
{
    check(options);
    const PartDistance distance{charts, distance_tolerance(options)};
    return Measurement{{charts, tree, options, distance}}.run();
}

std::string_view verdict_name(Verdict verdict)
{
    switch (verdict) {
        case Verdict::Clean:
            return "clean";
        case Verdict::Gouged:
            return "gouged";
        case Verdict::Uncut:
            return "uncut";
        case Verdict::Undecided:
            return "undecided";
    }
    return {};
}

Verdict verdict(const Deviation& deviation, const DeviationLimits& limits)
{
    const double tolerance = limits.tolerance + verdict_slack;
    const double scallop = limits.scallop + verdict_slack;
    if (deviation.max_gouge_mm > tolerance)
        return Verdict::Gouged;
    if (deviation.max_scallop_mm > scallop)
        return Verdict::Uncut;
    const bool is_certain =
        deviation.max_gouge_mm + deviation.gouge_bound_mm <= tolerance &&
        deviation.max_scallop_mm + deviation.scallop_bound_mm <= scallop;
    return is_certain ? Verdict::Clean : Verdict::Undecided;
}

}  // namespace endmill
