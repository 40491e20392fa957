// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/wear_and_force.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "endmill/core/parallel.h"
#include "endmill/process/detail/force_pattern.h"
#include "endmill/process/detail/segment_load.h"

namespace endmill {
namespace {

double peak_force_n(const MilledMove& move, const LoadModel& model,
                    const MillingTool& tool)
{
    const BallEngagement engagement = ball_engagement(move.cut, tool.radius);
    if (is_air(engagement))
        return 0;
    return ForcePattern{engagement, ChipModel::Paper, tool}
        .largest_loads(model, move.feed_per_tooth_mm)
        .cutting_force_n;
}

}  // namespace

std::vector<MilledMove> constant_moves(const std::vector<SegmentCut>& cuts, int flutes,
                                       double feed_mm_per_min, double spindle_rpm)
{
    std::vector<MilledMove> moves;
    moves.reserve(cuts.size());
    for (const SegmentCut& cut : cuts)
        moves.push_back({cut, feed_mm_per_min / (flutes * spindle_rpm), spindle_rpm});
    return moves;
}

double used_life(const std::vector<MilledMove>& moves, const MillingJob& job,
                 double life_min)
{
    constexpr double mm_per_m = 1000;
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

PeakForces peak_forces(const std::vector<MilledMove>& moves, const MillingJob& job,
                       double depth_mm)
{
    const LoadModel model{job.material, job.tool.radius};
    std::vector<double> forces(moves.size());
    parallel_for(moves.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            forces[i] = peak_force_n(moves[i], model, job.tool);
    });
    PeakForces peaks{0, 0};
    for (std::size_t i = 0; i < moves.size(); ++i) {
        peaks.all_n = std::max(peaks.all_n, forces[i]);
        if (moves[i].cut.depth_mm < depth_mm)
            peaks.shallow_n = std::max(peaks.shallow_n, forces[i]);
    }
    return peaks;
}

}  // namespace endmill
