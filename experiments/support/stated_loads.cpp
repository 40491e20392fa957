// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/stated_loads.h"

#include "endmill/process/detail/segment_load.h"

namespace endmill {

std::vector<CuttingLoads> stated_loads(const std::vector<MilledMove>& moves,
                                       const MillingJob& job, double peak_factor)
{
    constexpr double accuracy = 1e-8;  // of a coefficient
    const LoadModel model{job.material, job.tool.radius, LimitForm::Paper};
    std::vector<CuttingLoads> loads;
    loads.reserve(moves.size());
    for (const MilledMove& move : moves) {
        const BallEngagement engagement = ball_engagement(move.cut, job.tool.radius);
        if (is_air(engagement)) {
            loads.emplace_back();
            continue;
        }
        const CuttingCoefficients coefficients =
            cutting_coefficients(engagement, ChipModel::Paper, accuracy);
        loads.push_back(
            cutting_loads(model, edge_sums(coefficients, job.tool.flutes, peak_factor),
                          move.feed_per_tooth_mm));
    }
    return loads;
}

std::vector<double> cutting_forces(const std::vector<CuttingLoads>& loads)
{
    std::vector<double> forces;
    forces.reserve(loads.size());
    for (const CuttingLoads& load : loads)
        forces.push_back(load.cutting_force_n);
    return forces;
}

std::vector<double> thrusts(const std::vector<CuttingLoads>& loads)
{
    std::vector<double> forces;
    forces.reserve(loads.size());
    for (const CuttingLoads& load : loads)
        forces.push_back(load.thrust_n);
    return forces;
}

}  // namespace endmill
