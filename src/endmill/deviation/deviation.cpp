// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/deviation.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/core/text.h"
#include "endmill/deviation/detail/deviation_areas.h"
#include "endmill/deviation/detail/part_distance.h"
#include "endmill/deviation/detail/tile_measure.h"

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// Of the pitch: how closely the distance from the part is known.
constexpr double distance_share = 0.025;
// Of a greatest length: how closely it is measured.
constexpr double sharpness = 1e-3;
// Halves of halves of a patch: a square of them.
constexpr std::size_t tiles_a_group = 16;

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
        is_measured_.assign(cells, 1);
        of_tile_.resize(deviation_.tiles.size());
        Progress progress{options, 2 * of_tile_.size()};
        measure_all(progress);
        const auto earlier = static_cast<std::int64_t>(options.earlier_sweeps);
        deviation_.is_cut_by_path = std::ranges::any_of(
            sweeps_, [earlier](std::int32_t sweep) { return sweep >= earlier; });
        highest_ = measured_greatest(+1);
        deepest_ = measured_greatest(-1);
        refine(merged(), progress);
        for (int times = 1; times <= options.max_refine && !merged().is_cut; ++times)
            halve(times, progress);
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

    struct Candidate {
        double length;  // mm
        std::size_t tile;

        bool operator<(const Candidate& other) const
        {
            return std::pair{length, other.tile} < std::pair{other.length, tile};
        }
    };

    static DeviationPlace& greatest(Extremes& some, double sign)
    {
        return sign > 0 ? some.highest : some.deepest;
    }

    // The greatest length on that side, measured; what is only known to be no greater than
    // that, but for its sharpness, then counts as no more.
    std::optional<DeviationPlace> measured_greatest(double sign)
    {
        std::priority_queue<Candidate> candidates;
        for (std::size_t i = 0; i < of_tile_.size(); ++i)
            if (const double length = sign * greatest(of_tile_[i], sign).left; length > 0)
                candidates.push({length, i});
        const double spare = verdict_slack + 2 * measured_.distance.uncertainty();
        std::optional<DeviationPlace> best;
        while (!candidates.empty()) {
            const auto [length, tile] = candidates.top();
            const double known = best ? sign * best->left : 0;
            if (best && length <= known * (1 + sharpness) + spare)
                break;
            candidates.pop();
            const std::size_t at = greatest_of_tile(tile, sign);
            const bool was_measured = is_measured_[at] != 0;
            if (!was_measured)
                measure(tile, at, sign);
            DeviationPlace& place = greatest(of_tile_[tile], sign);
            if (sign * place.left > known)
                best = place;
            if (was_measured)
                break;
            place.left = deviation_.left[greatest_of_tile(tile, sign)];
            candidates.push({sign * place.left, tile});
        }
        if (best)
            lower_to(*best, sign);
        return best;
    }

    std::size_t greatest_of_tile(std::size_t number, double sign) const
    {
        const PartTile& tile = deviation_.tiles[number];
        const auto first =
            deviation_.left.begin() + static_cast<std::ptrdiff_t>(tile.first);
        const auto last = first + tile.cells();
        const auto found =
            sign > 0 ? std::max_element(first, last) : std::min_element(first, last);
        return static_cast<std::size_t>(found - deviation_.left.begin());
    }

    // Measures what counts of a ray, and makes it the greatest of its tile.
    void measure(std::size_t number, std::size_t at, double sign)
    {
        const PartTile& tile = deviation_.tiles[number];
        const PartCell cell = tile.cell(static_cast<int>(at - tile.first));
        std::optional<std::size_t> no_hint;
        const auto ray = measured_.charts.ray(cell.chart, cell.centre());
        const double left =
            shortened(deviation_.left[at], *ray, measured_.distance, no_hint);
        deviation_.left[at] = static_cast<float>(left);
        is_measured_[at] = 1;
        greatest(of_tile_[number], sign) = {left, *ray, cell.chart, cell.centre(),
                                            sweeps_[at]};
    }

    void lower_to(const DeviationPlace& best, double sign)
    {
        const double most = sign * best.left;
        for (std::size_t i = 0; i < of_tile_.size(); ++i) {
            if (sign > 0 && most <= limits_.scallop)
                of_tile_[i].uncut_area = 0;
            if (sign < 0 && most <= limits_.tolerance)
                of_tile_[i].gouge_area = 0;
            DeviationPlace& place = greatest(of_tile_[i], sign);
            if (sign * place.left <= most)
                continue;
            place.left = best.left;
            const PartTile& tile = deviation_.tiles[i];
            for (float& left : std::span{deviation_.left}.subspan(
                     tile.first, static_cast<std::size_t>(tile.cells())))
                if (sign * left > most)
                    left = static_cast<float>(best.left);
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
                std::optional<std::size_t> hint;
                for (std::size_t k = 0; k < count; ++k) {
                    measures[k].count(hint);
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
            deviation_.area[at] =
                cell.is_outer && left >= 0 ? 0 : static_cast<float>(cell.area);
            sweeps_[at] = cell.left.sweep;
            is_measured_[at] = cell.is_measured ? 1 : 0;
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
                of_tile_[i] = TileMeasure{measured_, deviation_.tiles[i]}.refined(
                    doubt, {.tolerance = gouge, .scallop = rest});
        });
    }

    // A cutter that no ray meets may still have cut between them.
    void halve(int times, Progress& progress)
    {
        for_tiles(progress, [&](std::size_t i) {
            const Extremes found =
                TileMeasure{measured_, deviation_.tiles[i]}.halved(times);
            if (!found.is_cut)
                return;
            of_tile_[i].merge(found);
            of_tile_[i].lower = std::min(of_tile_[i].lower, found.deepest.left);
        });
    }

    Extremes merged() const
    {
        Extremes found;
        for (const auto& place : {highest_, deepest_})
            if (place)
                found.take(*place);
        for (const Extremes& some : of_tile_)
            found.merge(some);
        return found;
    }

    Measured measured_;
    DeviationLimits limits_;
    Deviation deviation_;
    std::vector<Extremes> of_tile_;
    std::vector<std::int32_t> sweeps_;       // of each cell
    std::vector<std::uint8_t> is_measured_;  // of each, what counts of its ray
    std::optional<DeviationPlace> highest_;  // of the first rays
    std::optional<DeviationPlace> deepest_;
};

}  // namespace

Deviation measure_deviation(const PartCharts& charts, const SweepTree& tree,
                            const DeviationOptions& options)
{
    check(options);
    const PartDistance distance{charts, distance_share * options.pitch};
    return Measurement{{charts, tree, options, distance}}.run();
}

}  // namespace endmill
