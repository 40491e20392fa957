// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/pose_search.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/setup/detail/rectangle_fit.h"
#include "endmill/setup/detail/sector_fit.h"
#include "endmill/setup/detail/setup_order.h"
#include "endmill/setup/detail/setup_rules.h"
#include "endmill/visibility/detail/direction_count.h"
#include "endmill/visibility/visibility.h"

// The search looks at each tool axis twice.
//
// 1. The first pass finds the nearest cells of each tool axis and, where that is cheap,
//    an upper bound of the least area. The smallest of these bounds is known before the
//    second pass.
// 2. The second pass fits each tool axis. The fit stops early if its area exceeds the
//    least area that any thread knows. Such a fit cannot be the best, so that the result
//    does not depend on the order in which threads work.

namespace endmill {
namespace {

void require_unit(std::span<const Vec3> vectors)
{
    constexpr double tolerance =
        1e-6;  // of the length: vectors written with seven digits
    require(
        std::all_of(vectors.begin(), vectors.end(),
                    [](const Vec3& v) { return std::abs(v.norm() - 1) <= tolerance; }),
        "setup: need unit vectors");
}

PoseSearchResult fit(const Vec3& tool_axis, std::span<const Vec3> directions,
                     const PoseFitOptions& options, const AreaBounds& bounds)
{
    return options.family == RotaryFamily::CA
               ? sector_fit(tool_axis, directions, options, bounds)
               : rectangle_fit(tool_axis, directions, options, bounds);
}

// A minimum area that all threads lower. It is never below the area of the best pose. A
// fit is the same for every bound that is not below its area, so that all poses that can
// be the best are fitted as without a bound.
class SharedMinimum {
public:
    double value() const { return value_.load(std::memory_order_relaxed); }

    void lower(double value)
    {
        double seen = value_.load(std::memory_order_relaxed);
        while (value < seen && !value_.compare_exchange_weak(seen, value)) {
        }
    }

private:
    std::atomic<double> value_{std::numeric_limits<double>::infinity()};
};

std::optional<FittedPose> best_of(const std::vector<std::optional<FittedPose>>& fits)
{
    BestCandidate<FittedPose> best;
    for (const std::optional<FittedPose>& fit : fits) {
        if (fit)
            best.offer(*fit, score_of(*fit));
    }
    return best.best();
}

// `least` and `feasible` of a pose may come from two searches of limited accuracy. If the
// least pose fits the limits, it is the feasible one too.
std::optional<FittedPose> feasible_of(const PoseSearchResult& found,
                                      const PoseFitOptions& options)
{
    const bool fits = found.least && setup_rules(options.mode).has_signed_limits &&
                      is_within(found.least->phi, options.limits.phi) &&
                      is_within(found.least->theta, options.limits.theta);
    return fits ? found.least : found.feasible;
}

std::vector<Vec3> directions_of(std::span<const std::uint32_t> cells,
                                std::span<const Vec3> centres)
{
    std::vector<Vec3> directions;
    directions.reserve(cells.size());
    for (const std::uint32_t cell : cells)
        directions.push_back(centres[cell]);
    return directions;
}

void check_search(const VisibilityMap& map, std::span<const Vec3> centres,
                  const PoseFitOptions& options)
{
    check_pose_fit_options(options);
    require(centres.size() == map.cells(), "pose_search: need a centre for each cell");
    require_unit(centres);
}

class CellSearch {
public:
    CellSearch(const VisibilityMap& map, std::span<const Vec3> centres,
               const PoseFitOptions& options)
        : map_{map},
          centres_{centres},
          options_{options},
          looks_{options.progress},
          nearest_(centres.size()),
          least_(centres.size()),
          feasible_(centres.size()),
          is_skipped_(centres.size())
    {
    }

    PoseSearchResult run()
    {
        options_.nearest_cells(map_, centres_, [this](std::size_t pose, auto cells) {
            nearest_[pose] = std::move(cells);
            bound(pose);
            looks_.one_more();
        });
        parallel_for(centres_.size(), [this](std::size_t begin, std::size_t end) {
            for (std::size_t pose = begin; pose < end; ++pose) {
                fit_pose(pose);
                looks_.one_more();
            }
        });
        PoseSearchResult result;
        result.poses_tried = centres_.size();
        result.poses_skipped = static_cast<std::size_t>(
            std::count(is_skipped_.begin(), is_skipped_.end(), true));
        result.least = best_of(least_);
        result.feasible = best_of(feasible_);
        result.feasible = feasible_of(result, options_);
        if (const std::optional<FittedPose>& shown =
                result.feasible ? result.feasible : result.least)
            result.status = status_of(*shown);
        else
            result.status = SetupStatus::NoOpenHemisphere;
        return result;
    }

private:
    void bound(std::size_t pose)
    {
        if (options_.family == RotaryFamily::CA)
            return;
        const AreaBounds bounds = rectangle_bounds(
            centres_[pose], directions_of(nearest_[pose], centres_), options_);
        area_.lower(bounds.least);
        feasible_area_.lower(bounds.feasible);
    }

    void fit_pose(std::size_t pose)
    {
        const PoseSearchResult found =
            fit(centres_[pose], directions_of(nearest_[pose], centres_), options_,
                {area_.value(), feasible_area_.value()});
        is_skipped_[pose] = found.poses_skipped > 0 ? 1 : 0;
        keep(found.least, pose, least_, area_);
        keep(found.feasible, pose, feasible_, feasible_area_);
        nearest_[pose] = {};
    }

    static void keep(const std::optional<FittedPose>& fit, std::size_t pose,
                     std::vector<std::optional<FittedPose>>& fits, SharedMinimum& minimum)
    {
        if (!fit)
            return;
        minimum.lower(fit->area);
        fits[pose] = fit;
        fits[pose]->cell = pose;
    }

    const VisibilityMap& map_;
    std::span<const Vec3> centres_;
    const PoseFitOptions& options_;
    DirectionCount looks_;
    std::vector<std::vector<std::uint32_t>> nearest_;  // cells, for each tool axis
    std::vector<std::optional<FittedPose>> least_;
    std::vector<std::optional<FittedPose>> feasible_;
    std::vector<char> is_skipped_;
    SharedMinimum area_;
    SharedMinimum feasible_area_;
};

}  // namespace

PoseSearchResult pose_fit(const Vec3& tool_axis, std::span<const Vec3> directions,
                          const PoseFitOptions& options)
{
    require_unit({&tool_axis, 1});
    require_unit(directions);
    return fit(tool_axis, directions, options, {});
}

PoseSearchResult pose_search(const VisibilityMap& map, std::span<const Vec3> centres,
                             const PoseFitOptions& options)
{
    check_search(map, centres, options);
    return CellSearch{map, centres, options}.run();
}

std::vector<FittedPose> poses_within_limits(const VisibilityMap& map,
                                            std::span<const Vec3> centres,
                                            const PoseFitOptions& options)
{
    check_search(map, centres, options);
    std::vector<std::optional<FittedPose>> fits(centres.size());
    options.nearest_cells(map, centres, [&](std::size_t pose, const auto& cells) {
        fits[pose] = feasible_of(
            fit(centres[pose], directions_of(cells, centres), options, {}), options);
    });
    std::vector<FittedPose> poses;
    for (std::size_t pose = 0; pose < fits.size(); ++pose) {
        if (!fits[pose])
            continue;
        poses.push_back(*fits[pose]);
        poses.back().cell = pose;
    }
    return poses;
}

}  // namespace endmill
