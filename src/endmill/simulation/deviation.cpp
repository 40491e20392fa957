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
#include "endmill/simulation/part_distance.h"
#include "endmill/simulation/tile_measure.h"

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// Of the narrower limit, and of the pitch at least: how closely the distance from the part
// is known where a limit is broken.
constexpr double distance_share = 0.25;
constexpr double finest_distance_share = 0.02;
// Halves of halves of a patch: a square of them.
constexpr std::size_t tiles_a_group = 16;

// Close enough for what the distance is for, and no finer than the cells.
double distance_tolerance(const DeviationOptions& options)
{
    return std::max(
        distance_share * std::min(options.limits.scallop, options.limits.tolerance),
        finest_distance_share * options.pitch);
}

// The value that 99 % of the area does not reach, from a histogram over the leading bits
// of each value, that is in steps of 1/2048 of it.
double area_quantile(std::span<const float> values, std::span<const float> areas,
                     double share)
{
    constexpr int dropped_bits = 12;
    std::vector<double> bins(std::size_t{1} << (32 - 1 - dropped_bits));
    double total = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const float value =
            values[i] > 0 ? values[i] : 0.0F;  // not -0: its bits are high
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

void add_areas(Deviation& deviation)
{
    double rest = 0;
    for (std::size_t i = 0; i < deviation.left.size(); ++i) {
        const double left = deviation.left[i];
        const double area = deviation.area[i];
        deviation.area_mm2 += area;
        rest += area * std::max(left, 0.0);
    }
    if (deviation.area_mm2 > 0)
        deviation.mean_scallop_mm = rest / deviation.area_mm2;
    deviation.p99_scallop_mm = area_quantile(deviation.left, deviation.area, 0.99);
}

// No gouge is deeper than the lowest tip lies under the part's highest place.
double deepest_possible(const Extremes& found, const SweepTree& tree)
{
    double lowest = infinite;
    for (const StraightSweep& sweep : tree.sweeps())
        lowest = std::min({lowest, sweep.from().z(), sweep.to().z()});
    return std::max(0.0, found.top - lowest);
}

void add_extremes(Deviation& deviation, const Extremes& found, const SweepTree& tree)
{
    deviation.rays = found.rays;
    deviation.is_cut = found.is_cut;
    deviation.gouge_area_mm2 = found.gouge_area;
    deviation.uncut_area_mm2 = found.uncut_area;
    deviation.max_scallop_mm = std::max(0.0, found.highest.left);
    deviation.max_gouge_mm = std::max(0.0, -found.deepest.left);
    if (found.highest.left > 0)
        deviation.highest = found.highest;
    if (found.deepest.left < 0)
        deviation.deepest = found.deepest;
    deviation.scallop_bound_mm = std::max(0.0, found.upper - deviation.max_scallop_mm);
    const double most_gouge = std::min(-found.lower, deepest_possible(found, tree));
    deviation.gouge_bound_mm = std::max(0.0, most_gouge - deviation.max_gouge_mm);
}

void check(const DeviationOptions& options)
{
    require(options.limits.tolerance > 0 && std::isfinite(options.limits.tolerance),
            "measure_deviation: need 0 < tolerance");
    require(options.limits.scallop > 0 && std::isfinite(options.limits.scallop),
            "measure_deviation: need 0 < scallop");
    require(static_cast<bool>(options.stock), "measure_deviation: need a stock");
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
        measure_all(progress);
        Extremes found = merged();
        if (is_beyond(found)) {
            for_tiles(progress, [&](std::size_t i) {
                if (is_beyond(of_tile_[i]))
                    shorten(i);
            });
            found = merged();
        }
        refine(found, progress);
        add_extremes(deviation_, merged(), measured_.tree);
        add_areas(deviation_);
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
        found.gouge_area = found.uncut_area = 0;
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
            found.take(
                DeviationPlace{left, *ray, cell.chart, cell.centre(), sweeps_[at]});
            found.add_area(left, cell.area(*ray), limits_);
        }
    }

    // A few tiles at a time, always the same, so that nothing hangs on the threads.
    void measure_all(Progress& progress)
    {
        const std::size_t tiles = deviation_.tiles.size();
        const std::size_t groups = (tiles + tiles_a_group - 1) / tiles_a_group;
        parallel_for(groups, [&](std::size_t begin, std::size_t end) {
            for (std::size_t group = begin; group < end; ++group) {
                const std::size_t first = group * tiles_a_group;
                const std::size_t count = std::min(tiles_a_group, tiles - first);
                std::vector<TileMeasure> measures = TileMeasure::measured_together(
                    measured_, std::span{deviation_.tiles}.subspan(first, count));
                for (std::size_t k = 0; k < count; ++k) {
                    keep(first + k, measures[k]);
                    progress.step();
                }
            }
        });
    }

    void keep(std::size_t number, TileMeasure& measure)
    {
        const PartTile& tile = deviation_.tiles[number];
        for (std::size_t k = 0; k < measure.cells().size(); ++k) {
            const MeasuredCell& cell = measure.cells()[k];
            const std::size_t at =
                tile.first + static_cast<std::size_t>(measure.numbers()[k]);
            const double left = cell.value();
            deviation_.left[at] = static_cast<float>(left);
            deviation_.area[at] = cell.is_outer && left >= 0
                                      ? 0
                                      : static_cast<float>(cell.cell.area(cell.ray));
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
        if (gouge > limits_.tolerance + verdict_slack)
            return;
        Doubt doubt = doubt_beyond(rest, gouge, limits_);
        if (rest > limits_.scallop + verdict_slack)
            doubt.upper = infinite;  // that is settled; a gouge would still come first
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
