// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/helical_edge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "endmill/core/detail/bracketed_newton.h"
#include "endmill/core/error.h"

namespace endmill {
namespace {

using std::numbers::pi;

// The engagement itself or, in air, one with the same angles that is not in air:
// EngagedRegion requires it.
BallEngagement not_air(BallEngagement engagement)
{
    if (is_air(engagement)) {
        engagement.depth_ratio = 1;
        engagement.previous = PreviousPass::None;
    }
    return engagement;
}

}  // namespace

HelicalEdge::HelicalEdge(const BallEngagement& engagement, double helix)
    : is_air_{(require_sound(engagement), is_air(engagement))},
      region_{not_air(engagement)},
      tangent_{std::tan(helix)},
      shank_top_{std::max(1.0, engagement.depth_ratio)},
      shank_angle_{shank_angle(engagement)}
{
    require(std::abs(helix) < pi / 2, "HelicalEdge: need a helix below a right angle");
    require(shank_top_ * std::abs(tangent_) <= 2 * pi * most_windings,
            "HelicalEdge: the edge winds too often about the axis");
    if (is_air_)
        return;
    for (const BorderArc& arc : region_.borders(BorderSplit::Whole))
        add_runs(arc);
    for (const double height : {1.0, shank_top_})
        if (shank_top_ > 1)
            for (const double azimuth : {0.0, shank_angle_})
                add_event(azimuth + height * tangent_);
    std::sort(events_.begin(), events_.end());
    events_.erase(std::unique(events_.begin(), events_.end()), events_.end());
}

// Azimuth of a point of a run. It is computed from the side of the axis on which the run
// lies, so that it is continuous along the run.
double HelicalEdge::azimuth(const Run& run, const Vec3& at) const
{
    if (region_.is_radial(run.kind) && run.kind == BorderKind::Wall)
        return run.to > 0 ? pi / 2
                          : -pi / 2;  // passes through the axis, where runs are split
    return run.is_at_stock ? std::atan2(at.x(), std::max(0.0, at.y()))
                           : pi - std::atan2(at.x(), std::max(0.0, -at.y()));
}

// Azimuth of the tip at which the edge passes the point of a run.
double HelicalEdge::turn_at(const Run& run, double p) const
{
    const Vec3 at = region_.point(run.kind, p);
    return azimuth(run, at) + (1 + at.z()) * tangent_;
}

// Derivative of turn_at by p, times sin^2 of the latitude.
double HelicalEdge::turn_rate(const Run& run, double p) const
{
    const BorderPoint point = region_.moving_point(run.kind, p);
    const double square = point.at.x() * point.at.x() + point.at.y() * point.at.y();
    return point.turn + tangent_ * square * point.height;
}

// Parameter p at which the edge crosses a run when its tip is at the azimuth `turn`. The
// secant between the ends of the run is the first guess.
double HelicalEdge::crossing(const Run& run, double turn) const
{
    constexpr double least_step = 1e-14;  // of p, whose magnitude is at most 1
    const double secant = run.from + (run.to - run.from) * (turn - run.turn_from) /
                                         (run.turn_to - run.turn_from);
    return bracketed_newton(
        {run.from, run.to, run.turn_to > run.turn_from, secant}, least_step,
        [&](double p) -> ValueAndSlope {
            const BorderPoint point = region_.moving_point(run.kind, p);
            const double x = point.at.x();
            const double y = point.at.y();
            return {azimuth(run, point.at) + (1 + point.at.z()) * tangent_ - turn,
                    point.turn / (x * x + y * y) + tangent_ * point.height};
        });
}

// Splits a border where it crosses y = 0, the plane along the feed through the axis.
void HelicalEdge::add_runs(const BorderArc& arc)
{
    const double low = std::min(arc.from, arc.to);
    const double high = std::max(arc.from, arc.to);
    double middle = 0;  // for Front, and for the wall of an edge, which contains the axis
    if (arc.kind == BorderKind::PreviousBall)
        middle = region_.beside_axis();
    else if (arc.kind == BorderKind::Wall && region_.wall != 0)
        middle = high;
    std::array<double, 3> ends{low, std::clamp(middle, low, high), high};
    for (int k = 0; k < 2; ++k) {
        if (!(ends[k] < ends[k + 1]))
            continue;
        const double y = region_.point(arc.kind, (ends[k] + ends[k + 1]) / 2).y();
        add_monotonic({arc.kind, y >= 0, ends[k], ends[k + 1], 0, 0});
    }
}

// Splits a run at the local extrema of its azimuth at the tip, and stores the parts.
void HelicalEdge::add_monotonic(Run run)
{
    // The derivative is sampled for changes of sign, which bisection then locates. It is
    // smooth on a border of less than half a turn; an extremum that the samples miss is
    // insignificant.
    constexpr int samples = 24;
    constexpr int halvings = 40;
    const double end = run.to;
    const double step = (run.to - run.from) / samples;
    const auto keep = [&](double from, double to) {
        run.from = from;
        run.to = to;
        run.turn_from = turn_at(run, from);
        run.turn_to = turn_at(run, to);
        add_event(run.turn_from);
        add_event(run.turn_to);
        runs_.push_back(run);
    };
    double from = run.from;
    double last = run.from + step / 2;
    bool last_rises = turn_rate(run, last) > 0;
    for (int k = 1; k < samples; ++k) {
        const double p = last + step;
        const bool rises = turn_rate(run, p) > 0;
        if (rises != last_rises) {
            double low = last;
            double high = p;
            for (int j = 0; j < halvings; ++j) {
                const double middle = (low + high) / 2;
                (turn_rate(run, middle) > 0) == rises ? high = middle : low = middle;
            }
            keep(from, high);
            from = high;
        }
        last = p;
        last_rises = rises;
    }
    keep(from, end);
}

// Adds an event, reduced to [0, 2 pi).
void HelicalEdge::add_event(double turn)
{
    const double once = turn - 2 * pi * std::floor(turn / (2 * pi));
    events_.push_back(once < 2 * pi ? once : 0);
}

// Adds the engaged ranges on the ball: between neighbouring crossings the middle decides.
void HelicalEdge::add_ball(double turn, std::vector<EdgeRange>& ranges) const
{
    std::vector<double> heights{0, region_.depth};
    for (const Run& run : runs_) {
        const double least = std::min(run.turn_from, run.turn_to);
        const double most = std::max(run.turn_from, run.turn_to);
        const double windings = std::ceil((least - turn) / (2 * pi));
        for (double at = turn + 2 * pi * windings; at <= most; at += 2 * pi)
            if (at >= least && least < most)
                heights.push_back(
                    std::clamp(1 + region_.point(run.kind, crossing(run, at)).z(), 0.0,
                               region_.depth));
    }
    std::sort(heights.begin(), heights.end());
    for (std::size_t k = 1; k < heights.size(); ++k) {
        const EdgeRange range{heights[k - 1], heights[k]};
        const double middle = (range.from + range.to) / 2;
        const double here = turn - middle * tangent_;
        const double sine = std::sqrt(middle * (2 - middle));
        if (range.from == range.to ||
            !region_.has({sine * std::sin(here), sine * std::cos(here), middle - 1}))
            continue;
        if (!ranges.empty() && ranges.back().to == range.from)
            ranges.back().to = range.to;
        else
            ranges.push_back(range);
    }
}

// Adds the engaged ranges on the shank, one per winding of the edge.
void HelicalEdge::add_shank(double turn, std::vector<EdgeRange>& ranges) const
{
    const double bottom = turn - tangent_;
    const double top = turn - shank_top_ * tangent_;
    const double least = std::min(bottom, top);
    const double most = std::max(bottom, top);
    // The shank is engaged at azimuths from `winding` to `winding` plus its angle.
    for (double winding = 2 * pi * std::floor(least / (2 * pi)); winding <= most;
         winding += 2 * pi) {
        if (bottom == top) {
            if (bottom - winding < shank_angle_)
                ranges.push_back({1, shank_top_});
            continue;
        }
        const double first = (turn - winding) / tangent_;
        const double second = (turn - winding - shank_angle_) / tangent_;
        const double from = std::max(1.0, std::min(first, second));
        const double to = std::min(shank_top_, std::max(first, second));
        if (from < to)
            ranges.push_back({from, to});
    }
}

std::vector<EdgeRange> HelicalEdge::engaged(double turn) const
{
    std::vector<EdgeRange> ranges;
    if (is_air_)
        return ranges;
    add_ball(turn, ranges);
    if (shank_top_ > 1)
        add_shank(turn, ranges);
    std::sort(ranges.begin(), ranges.end(),
              [](const EdgeRange& a, const EdgeRange& b) { return a.from < b.from; });
    return ranges;
}

}  // namespace endmill
