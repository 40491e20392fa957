// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/deviation_measurement.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>
#include <utility>

#include "endmill/core/detail/large_pages.h"
#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/core/text.h"
#include "endmill/core/tolerance.h"
#include "endmill/deviation/detail/deviation_cells.h"
#include "endmill/deviation/detail/part_distance.h"
#include "endmill/deviation/detail/part_tiles.h"
#include "endmill/deviation/detail/tile_measure.h"

// The measurement runs tile by tile, in four steps.
// 1. `measure_all` cuts the first rays of all tiles, limits them to their empty balls and
//    bounds the thickness between them.
// 2. `measured_greatest` finds the exact maxima on both sides among rays that are known
//    by upper bounds only.
// 3. `refine` halves the cells whose bounds could change the verdict or a maximum.
// 4. `halve` is used if no ray met a move: it halves the cells that a move comes near.
// Each step runs on all threads and starts from the result of the step before for all
// tiles. No result depends on the order of the threads.

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// Accuracy of the distance from the part, as a share of the pitch.
constexpr double distance_share = 0.025;
// Relative accuracy of the greatest thickness and depth.
constexpr double sharpness = 1e-3;
// Tiles that are cut together. Tiles arise by halving a patch, so 16 consecutive ones
// form a square of neighbours.
constexpr std::size_t tiles_a_group = 16;

// Returns an upper bound of the depth of any gouge: the height of the part's highest
// place above the lowest tip.
double deepest_possible(const Extremes& found, const SweepTree& tree)
{
    double lowest = infinite;
    for (const StraightSweep& sweep : tree.sweeps())
        lowest = std::min({lowest, sweep.from().z(), sweep.to().z()});
    return std::max(0.0, found.top - lowest);
}

// Lowers the bounds to what is proved.
Extremes with_proof(Extremes found, const std::optional<DeviationLimits>& proved)
{
    if (proved) {
        found.upper = std::min(found.upper, proved->scallop);
        found.lower = std::max(found.lower, -proved->tolerance);
    }
    return found;
}

// Copies maxima, bounds and areas to the result.
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

// Checks the options.
void check(const MachinedStock& stock, const DeviationOptions& options)
{
    require(options.limits.tolerance > 0 && std::isfinite(options.limits.tolerance),
            "measure_deviation: need 0 < tolerance");
    require(options.limits.scallop > 0 && std::isfinite(options.limits.scallop),
            "measure_deviation: need 0 < scallop");
    require(static_cast<bool>(stock.initial_ray), "measure_deviation: need a stock");
    require(0 <= options.max_refine && options.max_refine <= 20,
            "measure_deviation: need 0 <= max_refine <= 20");
}

// Reports the progress; any thread may do a step.
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

// Measures the whole part.
class Measurement {
public:
    Measurement(const Measured& measured, const MachinedStock& stock)
        : measured_{measured},
          earlier_sweeps_{stock.earlier_sweeps},
          proved_{stock.proved},
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
        assign_in_large_pages(deviation_.left, cells, 0.0F);
        assign_in_large_pages(deviation_.area, cells, 0.0F);
        assign_in_large_pages(sweeps_, cells, -1);
        assign_in_large_pages(is_measured_, cells, std::uint8_t{1});
        assign_in_large_pages(of_tile_, deviation_.tiles.size(), Extremes{});
        of_tile_inaccessible_.resize(deviation_.tiles.size());
        Progress progress{options, 2 * of_tile_.size()};
        measure_all(progress);
        const auto earlier = static_cast<std::int64_t>(earlier_sweeps_);
        deviation_.is_cut_by_path = std::ranges::any_of(
            sweeps_, [earlier](std::int32_t sweep) { return sweep >= earlier; });
        highest_ = measured_greatest(+1);
        deepest_ = measured_greatest(-1);
        refine(merged(), progress);
        for (int times = 1; times <= options.max_refine && !merged().is_cut; ++times)
            halve(times, progress);
        add_extremes(deviation_, with_proof(merged(), proved_), measured_.tree);
        add_areas(deviation_);
        for (const Inaccessible& tile : of_tile_inaccessible_) {
            deviation_.inaccessible_area_mm2 += tile.area;
            deviation_.max_inaccessible_mm =
                std::max(deviation_.max_inaccessible_mm, tile.most);
        }
        return std::move(deviation_);
    }

private:
    // Runs `body` on every tile, on all threads.
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

    // The first rays of a tile that the cutter cannot reach.
    struct Inaccessible {
        double area = 0;  // mm^2
        double most = 0;  // greatest remaining stock, mm

        void add(const MeasuredCell& cell)
        {
            area += cell.area;
            most = std::max(most, cell.length());
        }
    };

    // A tile with the upper bound of its greatest length.
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

    // Returns the place of the greatest thickness (sign +1) or depth (sign -1), measured
    // exactly.
    // Some rays are known by an upper bound only. A priority queue takes the tile with
    // the greatest value; if that value is a bound, it is replaced by the exact one and
    // the tile goes back to the queue. The search ends when the greatest value is exact,
    // or exceeds the best by less than the accuracy. Values above the best are then
    // lowered to it.
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

    // Returns the number of the cell with the greatest value of a tile.
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

    // Replaces the value of a cell by the exact one and makes it the extreme of its tile.
    void measure(std::size_t number, std::size_t at, double sign)
    {
        const PartTile& tile = deviation_.tiles[number];
        const PartCell cell = tile.cell(static_cast<int>(at - tile.first));
        std::optional<std::size_t> no_hint;
        const auto ray = measured_.charts.ray(cell.chart, cell.centre());
        const double left =
            limited_thickness(deviation_.left[at], *ray, measured_.distance, no_hint);
        deviation_.left[at] = static_cast<float>(left);
        is_measured_[at] = 1;
        greatest(of_tile_[number], sign) = {left, *ray, cell.chart, cell.centre(),
                                            sweeps_[at]};
    }

    // Lowers all values on that side to the exact maximum.
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

    // Tiles are always grouped in the same way, so that the result does not depend on the
    // threads.
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
                    measures[k].limit_thicknesses(hint);
                    keep(first + k, measures[k]);
                    progress.step();
                }
            }
        });
    }

    // Stores the result of a tile.
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
                !cell.is_judged() && left >= 0 ? 0 : static_cast<float>(cell.area);
            if (cell.is_inaccessible)
                of_tile_inaccessible_[number].add(cell);
            sweeps_[at] = cell.cut.sweep;
            is_measured_[at] = cell.is_measured ? 1 : 0;
        }
        of_tile_[number] = measure.extremes();
    }

    // Refines the tiles whose bounds exceed the thresholds. These follow from the maxima
    // of all first rays, so that they do not depend on the order of the threads.
    void refine(const Extremes& found, Progress& progress)
    {
        const double rest = std::max(0.0, found.highest.left);
        const double gouge = std::max(0.0, -found.deepest.left);
        if (gouge > limits_.tolerance + verdict_slack)
            return;
        RefinementThresholds thresholds = refinement_thresholds(rest, gouge, limits_);
        if (rest > limits_.scallop + verdict_slack)
            // Uncut is certain; but a gouge would come first.
            thresholds.upper = infinite;
        if (proved_ && proved_->scallop <= thresholds.upper)
            thresholds.upper = infinite;
        if (proved_ && -proved_->tolerance >= thresholds.lower)
            thresholds.lower = -infinite;
        for_tiles(progress, [&](std::size_t i) {
            if (thresholds.are_exceeded(of_tile_[i].upper, of_tile_[i].lower))
                of_tile_[i] = TileMeasure{measured_, deviation_.tiles[i]}.refined(
                    thresholds, {.tolerance = gouge, .scallop = rest});
        });
    }

    // A cutter that no ray meets may still have cut between the rays.
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

    // Returns the extremes of the whole part.
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
    std::size_t earlier_sweeps_;
    std::optional<DeviationLimits> proved_;
    DeviationLimits limits_;
    Deviation deviation_;
    std::vector<Extremes> of_tile_;
    std::vector<Inaccessible> of_tile_inaccessible_;
    std::vector<std::int32_t> sweeps_;       // sweep of each cell
    std::vector<std::uint8_t> is_measured_;  // whether the value of each cell is exact
    std::optional<DeviationPlace> highest_;  // exact maxima of the first rays
    std::optional<DeviationPlace> deepest_;
};

}  // namespace

Deviation measure_deviation(const PartCharts& charts, const MachinedStock& stock,
                            const DeviationOptions& options)
{
    check(stock, options);
    const SweepTree tree{stock.sweeps};
    const PartDistance distance{charts, distance_share * options.pitch};
    return Measurement{{charts, tree, stock.initial_ray, options, distance}, stock}.run();
}

}  // namespace endmill
