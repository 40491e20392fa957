// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/stock_history.h"

#include "endmill/stock/detail/sweep_tree.h"

namespace endmill {

EarlierRun run_along(const ToolPath& path, const Cutter& cutter)
{
    EarlierRun run{cutter, false, {}};
    run.tips.reserve(path.points.size());
    for (const PathPoint& point : path.points)
        run.tips.push_back(point.location.tip);
    if (!path.points.empty()) {
        const Move first = path.points.front().move;
        run.stands_at_first = first != Move::Rapid && first != Move::Retract;
    }
    return run;
}

std::vector<StraightSweep> history_sweeps(const StockHistory& history)
{
    std::vector<StraightSweep> sweeps;
    sweeps.reserve(sweep_count(history));
    for (const EarlierRun& run : history.runs)
        for (std::size_t k = 0; k < run.tips.size(); ++k) {
            if (k > 0)
                sweeps.emplace_back(run.cutter, run.tips[k - 1], run.tips[k]);
            else if (run.stands_at_first)
                sweeps.emplace_back(run.cutter, run.tips[k], run.tips[k]);
        }
    return sweeps;
}

std::size_t sweep_count(const StockHistory& history)
{
    std::size_t count = 0;
    for (const EarlierRun& run : history.runs)
        if (!run.tips.empty())
            count += run.tips.size() - (run.stands_at_first ? 0 : 1);
    return count;
}

JoinedSweeps::JoinedSweeps(const StockHistory* history, const ToolPath& path,
                           const Cutter& cutter)
{
    if (history)
        sweeps_ = history_sweeps(*history);
    earlier_ = sweeps_.size();
    const std::vector<StraightSweep> own = path_sweeps(path, cutter);
    sweeps_.insert(sweeps_.end(), own.begin(), own.end());
    // A path that begins with a rapid has no sweep for its first point.
    first_point_ = static_cast<std::int32_t>(path.points.size() - own.size());
}

std::int32_t JoinedSweeps::point_of(std::int32_t sweep) const
{
    if (sweep < 0)
        return sweep;
    const auto after = sweep - static_cast<std::int32_t>(earlier_);
    return after < 0 ? by_earlier_run : after + first_point_;
}

}  // namespace endmill
