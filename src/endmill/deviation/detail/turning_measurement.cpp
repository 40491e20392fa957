// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/turning_measurement.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "endmill/core/detail/large_pages.h"
#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/core/tolerance.h"
#include "endmill/deviation/detail/deviation_cells.h"
#include "endmill/deviation/detail/part_tiles.h"
#include "endmill/deviation/detail/turning_tile.h"

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// Accuracy of the distance from the part, as a share of the pitch.
constexpr double distance_share = 0.025;

void check(const TurnedStock& stock, const DeviationOptions& options)
{
    require(options.limits.tolerance > 0 && std::isfinite(options.limits.tolerance),
            "measure_turning_deviation: need 0 < tolerance");
    require(options.limits.scallop > 0 && std::isfinite(options.limits.scallop),
            "measure_turning_deviation: need 0 < scallop");
    require(static_cast<bool>(stock.initial_ray),
            "measure_turning_deviation: need a stock");
    require(0 <= options.max_refine && options.max_refine <= 20,
            "measure_turning_deviation: need 0 <= max_refine <= 20");
}

bool are_upright(std::span<const ToolPiece> pieces)
{
    const auto is_upright = [](const ToolFrame& frame) {
        return (frame.axes.col(2) - Vec3::UnitZ()).norm() <= removal_axis_tolerance;
    };
    return std::ranges::all_of(pieces, [&](const ToolPiece& piece) {
        return is_upright(piece.motion.from()) && is_upright(piece.motion.to());
    });
}

double least_corner_radius(std::span<const ToolPiece> pieces)
{
    double least = infinite;
    for (const ToolPiece& piece : pieces)
        least = std::min(least, piece.body.cutter().corner_radius());
    return pieces.empty() ? 0 : least;
}

// Measures the whole part in two passes over the tiles: the first rays, then the cells
// whose bounds could change the result. Each pass starts from the result of the one before
// for all tiles, so that nothing depends on the threads.
class TurningMeasurement {
public:
    TurningMeasurement(const TurningMeasured& measured) : measured_{measured}
    {
        const DeviationOptions& options = measured.options;
        deviation_.pitch_mm = options.pitch;
        deviation_.tiles = part_tiles(measured.charts, options.pitch, options.most_cells);
        const std::size_t cells = cell_count(deviation_.tiles);
        assign_in_large_pages(deviation_.left, cells, 0.0F);
        assign_in_large_pages(deviation_.area, cells, 0.0F);
        of_tile_.resize(deviation_.tiles.size());
    }

    TurningDeviation run()
    {
        for_tiles([&](std::size_t i) { measure(i); });
        double gap = infinite;
        for (const OfTile& tile : of_tile_)
            gap = std::min(gap, tile.gap);
        refine(merged());
        add_extremes(merged());
        add_areas(deviation_);
        for (const OfTile& tile : of_tile_) {
            deviation_.inaccessible_area_mm2 += tile.inaccessible_area;
            deviation_.max_inaccessible_mm =
                std::max(deviation_.max_inaccessible_mm, tile.most_inaccessible);
        }
        return {std::move(deviation_), std::max(0.0, gap)};
    }

private:
    struct OfTile {
        Extremes extremes = {};
        double gap = infinite;
        double inaccessible_area = 0;  // mm^2
        double most_inaccessible = 0;  // mm
    };

    template <typename Body>
    void for_tiles(const Body& body)
    {
        parallel_for(of_tile_.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                body(i);
                const std::size_t done = ++done_;
                if (measured_.options.progress && done % 256 == 0)
                    measured_.options.progress(static_cast<double>(done) /
                                               static_cast<double>(2 * of_tile_.size()));
            }
        });
    }

    void measure(std::size_t number)
    {
        const PartTile& tile = deviation_.tiles[number];
        const TurningTile measure{measured_, tile};
        OfTile& found = of_tile_[number];
        found.extremes = measure.extremes();
        found.gap = measure.gap();
        for (std::size_t k = 0; k < measure.cells().size(); ++k) {
            const BoundedCell& bounded = measure.cells()[k];
            const std::size_t at =
                tile.first + static_cast<std::size_t>(measure.numbers()[k]);
            const double left = bounded.value();
            const double area = bounded.cell.area;
            deviation_.left[at] = static_cast<float>(left);
            deviation_.area[at] =
                !bounded.cell.is_judged() && left >= 0 ? 0 : static_cast<float>(area);
            if (bounded.cell.is_inaccessible) {
                found.inaccessible_area += area;
                found.most_inaccessible =
                    std::max(found.most_inaccessible, bounded.ray.high);
            }
        }
    }

    // Refines the tiles whose bounds could change the verdict.
    void refine(const Extremes& found)
    {
        const DeviationLimits& limits = measured_.options.limits;
        const double rest = std::max(0.0, found.highest.left);
        const double gouge = std::max(0.0, -found.deepest.left);
        if (gouge > limits.tolerance + verdict_slack)
            return;
        RefinementThresholds thresholds{limits.scallop + verdict_slack,
                                        -limits.tolerance - verdict_slack};
        if (rest > limits.scallop + verdict_slack)
            thresholds.upper = infinite;
        for_tiles([&](std::size_t i) {
            Extremes& extremes = of_tile_[i].extremes;
            if (thresholds.are_exceeded(extremes.upper, extremes.lower))
                extremes =
                    TurningTile{measured_, deviation_.tiles[i]}.refined(thresholds);
        });
    }

    Extremes merged() const
    {
        Extremes found;
        for (const OfTile& tile : of_tile_)
            found.merge(tile.extremes);
        return found;
    }

    void add_extremes(const Extremes& found)
    {
        deviation_.rays = found.rays;
        deviation_.is_cut = deviation_.is_cut_by_path = found.is_cut;
        deviation_.gouge_area_mm2 = found.gouge_area;
        deviation_.uncut_area_mm2 = found.uncut_area;
        deviation_.max_scallop_mm = std::max(0.0, found.highest.left);
        deviation_.max_gouge_mm = std::max(0.0, -found.deepest.left);
        if (found.highest.left > 0)
            deviation_.highest = found.highest;
        if (found.deepest.left < 0)
            deviation_.deepest = found.deepest;
        deviation_.scallop_bound_mm =
            std::max(0.0, found.upper - deviation_.max_scallop_mm);
        deviation_.gouge_bound_mm = std::max(0.0, -found.lower - deviation_.max_gouge_mm);
    }

    TurningMeasured measured_;
    Deviation deviation_;
    std::vector<OfTile> of_tile_;
    std::atomic<std::size_t> done_ = 0;
};

}  // namespace

TurningDeviation measure_turning_deviation(const PartCharts& charts,
                                           const TurnedStock& stock,
                                           const DeviationOptions& options)
{
    check(stock, options);
    const std::span<const ToolPiece> pieces = stock.pieces.pieces();
    const PartDistance distance{charts, distance_share * options.pitch};
    return TurningMeasurement{{charts, stock.pieces, stock.initial_ray, options, distance,
                               are_upright(pieces), least_corner_radius(pieces)}}
        .run();
}

}  // namespace endmill
