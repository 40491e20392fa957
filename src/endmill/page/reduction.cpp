// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/page/reduction.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "endmill/core/error.h"

namespace endmill {
namespace {

constexpr int finest = 24;  // the smallest tolerance is the extent over 2^24
// Longer runs are divided, since the time of a run may grow as the square of its points.
constexpr std::size_t longest_run = 4096;

// Squared distance of a point from the line between two others.
double squared_distance(const Vec3& point, const Vec3& from, const Vec3& to)
{
    const Vec3 along = to - from;
    const double length2 = along.squaredNorm();
    const double share =
        length2 > 0 ? std::clamp((point - from).dot(along) / length2, 0.0, 1.0) : 0.0;
    return (point - from - share * along).squaredNorm();
}

// What ends a run of points.
enum class RunEnd { KindOrPass, LengthOnly };

// Numbers of the points between runs, and of the first and the last point. A run is moves of one
// kind in one pass; its lines begin at the point before it.
std::vector<std::size_t> run_ends(const ToolPath& path, RunEnd ended_by)
{
    std::vector<std::size_t> ends;
    const auto& points = path.points;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const bool is_outer = k == 0 || k + 1 == points.size();
        if (is_outer || k - ends.back() == longest_run ||
            (ended_by == RunEnd::KindOrPass && (points[k].move != points[k + 1].move ||
                                                points[k].pass != points[k + 1].pass)))
            ends.push_back(k);
    }
    return ends;
}

// For each point the squared tolerance from which on it is left out; infinite at ends of runs.
// A point within a run is not more important than the point that divides its stretch.
std::vector<double> importances(const ToolPath& path, std::span<const std::size_t> ends)
{
    const auto tip = [&](std::size_t k) -> const Vec3& {
        return path.points[k].location.tip;
    };
    std::vector<double> importance(path.points.size(), INFINITY);
    struct Stretch {
        std::size_t first;
        std::size_t last;
        double most;
    };
    std::vector<Stretch> open;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        open.push_back({ends[i], ends[i + 1], INFINITY});
    while (!open.empty()) {
        const auto [first, last, most] = open.back();
        open.pop_back();
        if (last - first < 2)
            continue;
        std::size_t farthest = first + 1;
        double greatest = -1;
        for (std::size_t k = first + 1; k < last; ++k) {
            const double distance = squared_distance(tip(k), tip(first), tip(last));
            if (distance > greatest) {
                greatest = distance;
                farthest = k;
            }
        }
        importance[farthest] = std::min(greatest, most);
        open.push_back({first, farthest, importance[farthest]});
        open.push_back({farthest, last, importance[farthest]});
    }
    return importance;
}

double extent_of(const ToolPath& path)
{
    const auto box = path_totals(path).extent;
    return box ? (box->high - box->low).norm() : 0;
}

}  // namespace

ReducedPath reduced_path(const ToolPath& path, std::size_t most_points)
{
    require(most_points >= 2, "reduced_path: need most_points >= 2");
    ReducedPath reduced;
    if (path.points.size() <= most_points) {
        for (std::size_t k = 0; k < path.points.size(); ++k)
            reduced.points.push_back(k);
        return reduced;
    }
    std::vector<std::size_t> ends = run_ends(path, RunEnd::KindOrPass);
    reduced.joins_moves = ends.size() > most_points;
    if (reduced.joins_moves)
        ends = run_ends(path, RunEnd::LengthOnly);
    const std::vector<double> importance = importances(path, ends);
    const double extent = extent_of(path);
    for (int power = finest; power >= 0; --power) {
        reduced.tolerance_mm = std::ldexp(extent, -power);
        const double limit = reduced.tolerance_mm * reduced.tolerance_mm;
        const auto left = static_cast<std::size_t>(
            std::ranges::count_if(importance, [&](double one) { return one > limit; }));
        if (left <= most_points || power == 0) {
            for (std::size_t k = 0; k < importance.size(); ++k)
                if (importance[k] > limit)
                    reduced.points.push_back(k);
            break;
        }
    }
    return reduced;
}

std::vector<std::size_t> extremes(std::span<const float> values, std::size_t most)
{
    require(most >= 2, "extremes: need most >= 2");
    std::vector<std::size_t> kept;
    if (values.size() <= most) {
        for (std::size_t k = 0; k < values.size(); ++k)
            if (std::isfinite(values[k]))
                kept.push_back(k);
        return kept;
    }
    const std::size_t runs = most / 2;
    for (std::size_t run = 0; run < runs; ++run) {
        const std::size_t begin = values.size() * run / runs;
        const std::size_t end = values.size() * (run + 1) / runs;
        std::size_t least = end;
        std::size_t greatest = end;
        for (std::size_t k = begin; k < end; ++k) {
            if (!std::isfinite(values[k]))
                continue;
            least = least == end || values[k] < values[least] ? k : least;
            greatest = greatest == end || values[k] > values[greatest] ? k : greatest;
        }
        if (least == end)
            continue;
        kept.push_back(std::min(least, greatest));
        if (least != greatest)
            kept.push_back(std::max(least, greatest));
    }
    return kept;
}

}  // namespace endmill
