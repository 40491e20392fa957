// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/stroke_forces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "endmill/process/cutting_force.h"
#include "endmill/process/detail/segment_load.h"

namespace endmill {
namespace {

CuttingForce combined(const CuttingForce& one, const CuttingForce& other,
                      double (*choose)(double, double))
{
    return {choose(one.x_n, other.x_n), choose(one.y_n, other.y_n),
            choose(one.z_n, other.z_n), choose(one.torque_n_m, other.torque_n_m)};
}

double lesser(double a, double b)
{
    return std::min(a, b);
}

double larger(double a, double b)
{
    return std::max(a, b);
}

double larger_magnitude(double a, double b)
{
    return std::max(std::abs(a), std::abs(b));
}

}  // namespace

std::vector<CuttingForce> turn_forces(const MilledMove& move, const MillingJob& job,
                                      int steps)
{
    const BallEngagement engagement = ball_engagement(move.cut, job.tool.radius);
    if (is_air(engagement))
        return std::vector<CuttingForce>(static_cast<std::size_t>(steps));
    std::vector<double> turns;
    for (int i = 0; i < steps; ++i)
        turns.push_back(2 * std::numbers::pi * i / steps);
    return force_profile({.engagement = engagement,
                          .material = job.material,
                          .tool = job.tool,
                          .feed_per_tooth_mm = move.feed_per_tooth_mm,
                          .milling = move.cut.milling},
                         turns);
}

TurnRange turn_range(const MilledMove& move, const MillingJob& job, int steps)
{
    const std::vector<CuttingForce> forces = turn_forces(move, job, steps);
    TurnRange range{forces.front(), forces.front()};
    for (const CuttingForce& force : forces)
        range = {combined(range.least, force, lesser),
                 combined(range.greatest, force, larger)};
    return range;
}

StrokeForces stroke_forces(const std::vector<MilledMove>& moves,
                           const std::vector<TurnRange>& ranges, const MillingJob& job)
{
    StrokeForces stroke;
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const auto& [cut, feed, speed] = moves[i];
        const double minutes = cut.length_mm / (job.tool.flutes * feed * speed);
        const double i7 =
            cutting_coefficients(ball_engagement(cut, job.tool.radius), ChipModel::Paper)
                .I7;
        stroke.minutes += minutes;
        // What a tooth removes a feed is 2 pi r0^2 I7 in section.
        stroke.removed_mm3 +=
            cut.length_mm * 2 * std::numbers::pi * job.tool.radius * job.tool.radius * i7;
        const CuttingForce largest =
            combined(ranges[i].least, ranges[i].greatest, larger_magnitude);
        stroke.largest = combined(stroke.largest, largest, larger);
        if (cut.lambda < 0)
            stroke.largest_downhill = combined(stroke.largest_downhill, largest, larger);
    }
    return stroke;
}

NamedCells stroke_cells(const StrokeForces& stroke)
{
    return {{"minutes", stroke.minutes},
            {"removed_mm3_per_min", stroke.removed_mm3 / stroke.minutes},
            {"force_x_n", stroke.largest.x_n},
            {"force_y_n", stroke.largest.y_n},
            {"thrust_n", stroke.largest.z_n},
            {"downhill_x_n", stroke.largest_downhill.x_n},
            {"downhill_y_n", stroke.largest_downhill.y_n},
            {"downhill_thrust_n", stroke.largest_downhill.z_n}};
}

}  // namespace endmill
