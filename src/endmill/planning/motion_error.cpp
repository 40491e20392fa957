// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/motion_error.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "endmill/planning/detail/iso_cuts.h"
#include "endmill/planning/detail/segment_distance.h"

namespace endmill {
namespace {

constexpr double resolution_per_radius = 1e-6;
// Halvings of an interval, whose deviation from its chord falls by 4 each time.
constexpr int most_halvings = 40;

// A move of the centre, beside the line from u = from to u = to.
struct CentreMove {
    double from;
    double to;
    Vec3 start;
    Vec3 end;
};

// A part of the line, and how far it may stray from its chord.
struct LineInterval {
    double low;
    double high;
    Vec3 at_low;
    Vec3 at_high;
    double bend;  // bound on the line's second derivative
    int halvings;

    double chord_error() const { return (high - low) * (high - low) / 8 * bend; }
};

class MotionMeter {
public:
    explicit MotionMeter(double radius)
        : radius_{radius},
          error_{{}, {}, resolution_per_radius * radius}
    {
    }

    void measure(const IsoLine& line, const CentreMove& move, int patch,
                 std::span<const double> breaks)
    {
        const auto [low, high] = std::minmax(move.from, move.to);
        std::vector<LineInterval> open;
        double from = low;
        for (const double border : breaks)
            if (low < border && border < high) {
                open.push_back(interval(line, from, border));
                from = border;
            }
        open.push_back(interval(line, from, high));
        for (const double u : {low, high})
            note(line.point(u), u, line, move, patch);
        while (!open.empty()) {
            const LineInterval next = std::move(open.back());
            open.pop_back();
            if (is_settled(next, move))
                continue;
            const double middle = (next.low + next.high) / 2;
            const Vec3 at_middle = line.point(middle);
            note(at_middle, middle, line, move, patch);
            const int halvings = next.halvings + 1;
            open.push_back(
                {next.low, middle, next.at_low, at_middle, next.bend, halvings});
            open.push_back(
                {middle, next.high, at_middle, next.at_high, next.bend, halvings});
        }
    }

    const MotionError& error() const { return error_; }

private:
    static LineInterval interval(const IsoLine& line, double low, double high)
    {
        return {low, high, line.point(low), line.point(high), line.bend_bound(low, high),
                0};
    }

    void note(const Vec3& point, double u, const IsoLine& line, const CentreMove& move,
              int patch)
    {
        const double left = segment_distance(point, move.start, move.end) - radius_;
        LineDeviation& deviation = left > 0 ? error_.left : error_.gouge;
        if (std::abs(left) > deviation.greatest_mm)
            deviation = {std::abs(left), {u, line.v()}, patch};
    }

    // Whether no point of the interval deviates by more than is known already. Distance
    // from a convex set is convex: greatest at an end of the chord, and not below its
    // tangent plane.
    bool is_settled(const LineInterval& interval, const CentreMove& move) const
    {
        if (interval.halvings == most_halvings)
            return true;
        const double stray = interval.chord_error();
        const auto distance = [&](const Vec3& point) {
            return segment_distance(point, move.start, move.end);
        };
        const double greatest =
            std::max(distance(interval.at_low), distance(interval.at_high)) + stray;
        if (greatest - radius_ > error_.left.greatest_mm + error_.bound_mm)
            return false;
        const Vec3 middle = (interval.at_low + interval.at_high) / 2;
        const Vec3 nearest = nearest_on_segment(middle, move.start, move.end);
        const Vec3 away = (middle - nearest).stableNormalized();
        const double least =
            std::max(0.0, std::min(away.dot(interval.at_low - nearest),
                                   away.dot(interval.at_high - nearest)) -
                              stray);
        return radius_ - least <= error_.gouge.greatest_mm + error_.bound_mm;
    }

    double radius_;
    MotionError error_;
};

}  // namespace

double MotionError::greatest_mm() const
{
    return std::max(gouge.greatest_mm, left.greatest_mm);
}

MotionError motion_error(std::span<const Surface> surfaces, const ToolPath& path,
                         const BallCutter& cutter, Parameter along)
{
    const auto centre = [&](const PathPoint& point) -> Vec3 {
        return point.location.tip + cutter.radius() * point.location.axis;
    };
    MotionMeter meter{cutter.radius()};
    for_each_iso_cut(surfaces, path, along, [&](const IsoCut& move) {
        meter.measure(move.line,
                      {move.from, move.to, centre(move.start), centre(move.end)},
                      move.start.patch, move.surface.breaks(Parameter::U));
    });
    MotionError error = meter.error();
    if (along == Parameter::V)
        for (LineDeviation* deviation : {&error.gouge, &error.left})
            std::swap(deviation->at.u, deviation->at.v);
    return error;
}

}  // namespace endmill
