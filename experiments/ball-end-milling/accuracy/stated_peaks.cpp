// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball-end-milling/accuracy/stated_peaks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "endmill/process/cutting_force.h"
#include "endmill/process/detail/segment_load.h"
#include "support/path_statistics.h"

namespace endmill {

std::vector<CuttingLoads> torque_stated_loads(const std::vector<MilledMove>& moves,
                                              const MillingJob& job)
{
    std::vector<CuttingLoads> loads = stated_loads(moves, job, 1);
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const BallEngagement engagement = ball_engagement(moves[i].cut, job.tool.radius);
        const double factor =
            is_air(engagement) ? 1 : peak_factor(engagement, ChipModel::Paper, job.tool);
        loads[i].cutting_force_n *= factor;
        loads[i].thrust_n *= factor;
        loads[i].torque_n_m *= factor;
    }
    return loads;
}

PeakRatios::PeakRatios(const std::vector<MilledMove>& moves,
                       const std::vector<CuttingLoads>& peaks,
                       const std::vector<CuttingLoads>& stated)
{
    for (std::size_t i = 0; i < moves.size(); ++i)
        if (stated[i].cutting_force_n > 0) {
            lengths_.push_back(moves[i].cut.length_mm);
            slopes_.push_back(moves[i].cut.lambda);
            forces_.push_back(peaks[i].cutting_force_n / stated[i].cutting_force_n);
            thrusts_.push_back(peaks[i].thrust_n / stated[i].thrust_n);
        }
}

double PeakRatios::within_percent(double tolerance) const
{
    double within = 0;
    double length = 0;
    for (std::size_t i = 0; i < forces_.size(); ++i) {
        length += lengths_[i];
        if (std::abs(forces_[i] - 1) <= tolerance)
            within += lengths_[i];
    }
    return 100 * within / length;
}

double PeakRatios::force_quantile(double share) const
{
    return weighted_quantile(forces_, lengths_, share);
}

bool PeakRatios::is_thrust_understated_downhill() const
{
    return mean_thrust(true) > mean_thrust(false);
}

NamedCells PeakRatios::force_cells(double tolerance) const
{
    return {{"within_percent", within_percent(tolerance)},
            {"ratio_5", force_quantile(0.05)},
            {"ratio_50", force_quantile(0.5)},
            {"ratio_95", force_quantile(0.95)},
            {"ratio_greatest", std::ranges::max(forces_)}};
}

NamedCells PeakRatios::thrust_cells() const
{
    return {{"thrust_downhill", mean_thrust(true)},
            {"thrust_uphill", mean_thrust(false)},
            {"thrust_understated_downhill", word(is_thrust_understated_downhill())}};
}

double PeakRatios::mean_thrust(bool is_downhill) const
{
    double sum = 0;
    double length = 0;
    for (std::size_t i = 0; i < thrusts_.size(); ++i)
        if (is_downhill ? slopes_[i] < 0 : slopes_[i] > 0) {
            sum += lengths_[i] * thrusts_[i];
            length += lengths_[i];
        }
    return sum / length;
}

double over_percent(const std::vector<MilledMove>& moves,
                    const std::vector<CuttingLoads>& peaks, const MillingJob& job)
{
    constexpr double tolerance = 0.02;  // as in stock-engagement
    const double limit = *job.tool.limits.cutting_force_n * (1 + tolerance);
    double over = 0;
    double length = 0;
    for (std::size_t i = 0; i < moves.size(); ++i) {
        length += moves[i].cut.length_mm;
        if (peaks[i].cutting_force_n > limit)
            over += moves[i].cut.length_mm;
    }
    return 100 * over / length;
}

void Extremes::add(const PeakRatios& ratios, double tolerance, double over)
{
    least_within = std::min(least_within, ratios.within_percent(tolerance));
    greatest_over = std::max(greatest_over, over);
    is_understated = is_understated && ratios.is_thrust_understated_downhill();
}

NamedCells Extremes::cells() const
{
    return {{"within_percent", least_within},
            {"over_percent", greatest_over},
            {"thrust_understated_downhill", word(is_understated)}};
}

void add_quantiles(CsvTable& table, const std::string& name, const PeakRatios& ratios)
{
    for (int percent = 1; percent <= 100; ++percent)
        table.add_row({name + " " + std::to_string(percent), std::int64_t{percent},
                       ratios.force_quantile(percent / 100.0), name});
}

}  // namespace endmill
