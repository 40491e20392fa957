// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/ramp_entry.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/post/detail/descent.h"

namespace endmill {
namespace {

// More turns than this are no slope: the cuts are too short.
constexpr double most_returns = 50;

// The cuts after a plunge, with the distance from their start, seen from above.
struct Run {
    std::vector<Vec3> tips;
    std::vector<double> distances;  // mm

    void add(const Vec3& tip)
    {
        const double step = tips.empty() ? 0 : (tip - tips.back()).head<2>().norm();
        distances.push_back(tips.empty() ? 0 : distances.back() + step);
        tips.push_back(tip);
    }
    double length() const { return distances.back(); }

    // The tip at a distance from the start. \pre 0 <= distance <= length()
    Vec3 at(double distance) const
    {
        const auto after = std::ranges::lower_bound(distances, distance);
        const auto k = static_cast<std::size_t>(after - distances.begin());
        if (k == 0)
            return tips.front();
        const double part =
            (distance - distances[k - 1]) / (distances[k] - distances[k - 1]);
        return tips[k - 1] + part * (tips[k] - tips[k - 1]);
    }
};

// The cuts from point `plunge` on, as far as `enough` mm seen from above.
Run run_after(const ToolPath& path, std::size_t plunge, double enough)
{
    const std::vector<PathPoint>& points = path.points;
    Run run;
    run.add(points[plunge].location.tip);
    for (std::size_t k = plunge + 1; k < points.size() && run.length() < enough; ++k) {
        const bool same_tool =
            points[k].conditions.tool == points[plunge].conditions.tool;
        if (points[k].move != Move::Cut || !same_tool)
            break;
        run.add(points[k].location.tip);
    }
    return run;
}

// Adds the points of slopes to a path.
class RampWriter {
public:
    RampWriter(RampedPath& result, double tangent) : result_{result}, tangent_{tangent} {}

    // Adds the slope to the plunge with this index, without its last point. Adds nothing
    // and returns false if the slope has no room.
    // \param depth mm, above 0.
    bool add(const ToolPath& path, std::size_t plunge, double depth)
    {
        const double length = depth / tangent_;
        const Run run = run_after(path, plunge, length / 2);
        const double returns = std::ceil(length / (2 * run.length()));
        if (!(returns <= most_returns)) {
            ++result_.straight;
            return false;
        }
        ++result_.ramps;
        const double reach = length / (2 * returns);  // of one way forward
        for (double begun = 0; begun < returns; ++begun)
            add_return(run, path.points[plunge],
                       {depth, length, 2 * reach * begun, std::min(reach, run.length())});
        return true;
    }

private:
    struct Leg {
        double depth;   // mm, of the whole slope
        double length;  // mm, of the whole slope
        double begin;   // mm along the slope
        double reach;   // mm, forward
    };

    // Goes forward and back once.
    void add_return(const Run& run, const PathPoint& plunge, const Leg& leg)
    {
        const auto past = std::ranges::lower_bound(run.distances, leg.reach);
        const auto inner = static_cast<std::size_t>(past - run.distances.begin());
        for (std::size_t k = 1; k < inner; ++k)
            add_point(plunge, run.tips[k], leg, run.distances[k]);
        add_point(plunge, run.at(leg.reach), leg, leg.reach);
        for (std::size_t k = inner; k-- > 1;)
            add_point(plunge, run.tips[k], leg, 2 * leg.reach - run.distances[k]);
        add_point(plunge, run.tips.front(), leg, 2 * leg.reach);
    }

    // Adds a point at a distance from the beginning of the leg. The end of the slope is
    // the plunge itself, which the caller adds.
    void add_point(const PathPoint& plunge, const Vec3& tip, const Leg& leg,
                   double distance)
    {
        const double left = 1 - (leg.begin + distance) / leg.length;
        if (left < end_of_slope)
            return;
        PathPoint point = plunge;
        point.move = Move::Plunge;
        point.known_contact = {};
        point.location.tip = tip + leg.depth * left * Vec3::UnitZ();
        result_.path.points.push_back(point);
    }

    // Share of the slope below which a point is its end, up to rounding.
    static constexpr double end_of_slope = 1e-12;

    RampedPath& result_;
    double tangent_;
};

}  // namespace

RampedPath with_ramps(const ToolPath& path, double start_height, double tangent)
{
    require(std::isfinite(tangent) && tangent > 0,
            "with_ramps: need an angle between 0 and 90 degrees");
    RampedPath result;
    result.path.points.reserve(path.points.size());
    RampWriter writer{result, tangent};
    for (std::size_t k = 0; k < path.points.size(); ++k) {
        const auto descent = descent_at(path, k, start_height);
        if (!descent) {
            result.path.points.push_back(path.points[k]);
            continue;
        }
        const bool is_slope =
            writer.add(path, descent->last, descent->from - descent->to);
        for (k = is_slope ? descent->last : k; k <= descent->last; ++k) {
            result.path.points.push_back(path.points[k]);
            result.path.points.back().move = Move::Plunge;
        }
        k = descent->last;
    }
    return result;
}

}  // namespace endmill
