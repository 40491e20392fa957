// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/stroke_forces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "endmill/core/detail/units.h"
#include "endmill/core/parallel.h"
#include "endmill/process/cutting_force.h"
#include "endmill/process/detail/force_pattern.h"
#include "endmill/process/detail/front_load.h"
#include "endmill/process/detail/segment_load.h"

namespace endmill {
namespace {

// Applies `choose` to each component.
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

// Largest loads of each move. `largest_loads` computes the loads of one move from its
// number, the load model and its feed per tooth.
template <typename LargestLoads>
std::vector<CuttingLoads> peaks_of(const std::vector<MilledMove>& moves,
                                   const MillingJob& job,
                                   const LargestLoads& largest_loads)
{
    const LoadModel model{job.material, job.tool.radius};
    std::vector<CuttingLoads> peaks(moves.size());
    parallel_for(moves.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            peaks[i] = largest_loads(i, model, moves[i].feed_per_tooth_mm);
    });
    return peaks;
}

std::vector<double> cutting_forces_of(const std::vector<CuttingLoads>& loads)
{
    std::vector<double> forces;
    forces.reserve(loads.size());
    for (const CuttingLoads& load : loads)
        forces.push_back(load.cutting_force_n);
    return forces;
}

}  // namespace

std::vector<MilledMove> milled_moves(const std::vector<SegmentCut>& cuts,
                                     const FeedPlan& plan,
                                     const std::optional<double>& feed_per_tooth_mm)
{
    std::vector<MilledMove> moves;
    moves.reserve(cuts.size());
    for (std::size_t i = 0; i < cuts.size(); ++i)
        moves.push_back({cuts[i],
                         feed_per_tooth_mm.value_or(plan.rows[i].tooth.feed_per_tooth_mm),
                         plan.rows[i].table.spindle_rpm});
    return moves;
}

std::vector<MilledMove> constant_moves(const std::vector<SegmentCut>& cuts, int flutes,
                                       double feed_mm_per_min, double spindle_rpm)
{
    std::vector<MilledMove> moves;
    moves.reserve(cuts.size());
    for (const SegmentCut& cut : cuts)
        moves.push_back({cut, feed_mm_per_min / (flutes * spindle_rpm), spindle_rpm});
    return moves;
}

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

ForceRange turn_range(const MilledMove& move, const MillingJob& job, int steps)
{
    const std::vector<CuttingForce> forces = turn_forces(move, job, steps);
    ForceRange range{forces.front(), forces.front()};
    for (const CuttingForce& force : forces)
        range = {combined(range.least, force, lesser),
                 combined(range.greatest, force, larger)};
    return range;
}

StrokeForces stroke_forces(const std::vector<MilledMove>& moves,
                           const std::vector<ForceRange>& ranges, const MillingJob& job)
{
    StrokeForces stroke;
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const auto& [cut, feed, speed] = moves[i];
        const double minutes = cut.length_mm / (job.tool.flutes * feed * speed);
        const double i7 =
            cutting_coefficients(ball_engagement(cut, job.tool.radius), ChipModel::Paper)
                .I7;
        stroke.minutes += minutes;
        // The section that all teeth together remove across the move is 2 pi r0^2 I7.
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

double used_life(const std::vector<MilledMove>& moves, const MillingJob& job,
                 double life_min)
{
    double used = 0;
    for (const auto& [cut, feed, rpm] : moves) {
        const double minutes = cut.length_mm / (job.tool.flutes * feed * rpm);
        const double speed = 2 * std::numbers::pi * job.tool.radius * rpm / mm_per_m;
        const double phi_over_pi =
            tool_life_angle(ball_engagement(cut, job.tool.radius)) / std::numbers::pi;
        const double life =
            life_min *
            std::pow(job.material.v1_m_per_min / speed, 1 / job.material.alpha) /
            phi_over_pi;
        used += minutes / life;
    }
    return used;
}

std::vector<CuttingLoads> peak_loads(const std::vector<MilledMove>& moves,
                                     const MillingJob& job)
{
    return peaks_of(moves, job, [&](std::size_t i, const LoadModel& model, double feed) {
        const BallEngagement engagement = ball_engagement(moves[i].cut, job.tool.radius);
        return is_air(engagement)
                   ? CuttingLoads{}
                   : ForcePattern{engagement, ChipModel::Paper, job.tool}.largest_loads(
                         model, feed);
    });
}

std::vector<double> peak_cutting_forces(const std::vector<MilledMove>& moves,
                                        const MillingJob& job)
{
    return cutting_forces_of(peak_loads(moves, job));
}

std::vector<double> peak_cutting_forces(const std::vector<MilledMove>& moves,
                                        const std::vector<BallFront>& fronts,
                                        const MillingJob& job)
{
    return cutting_forces_of(
        peaks_of(moves, job, [&](std::size_t i, const LoadModel& model, double feed) {
            return FrontPattern{fronts[i], ChipModel::Paper, job.tool}.largest_loads(
                model, feed);
        }));
}

}  // namespace endmill
