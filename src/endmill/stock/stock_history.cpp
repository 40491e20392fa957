// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/stock_history.h"

#include <string>
#include <utility>

#include "endmill/core/error.h"

namespace endmill {

std::vector<StraightSweep> path_sweeps(const ToolPath& path, const Cutter& cutter)
{
    std::vector<StraightSweep> sweeps;
    sweeps.reserve(path.points.size());
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        const PathPoint& point = path.points[i];
        if (point.location.axis != Vec3::UnitZ())
            throw GeometryError{"point " + std::to_string(i) +
                                " of the path: the axis is not +z; expected a path for a "
                                "fixed, upright cutter"};
        if (i > 0)
            sweeps.emplace_back(cutter, path.points[i - 1].location.tip,
                                point.location.tip);
        else if (point.move != Move::Rapid && point.move != Move::Retract)
            sweeps.emplace_back(cutter, point.location.tip, point.location.tip);
    }
    return sweeps;
}

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

EarlierTurningRun turning_run_along(const ToolPath& path, std::size_t first,
                                    std::size_t end, const CuttingBody& cutter,
                                    bool stands)
{
    EarlierTurningRun run{cutter, stands, {}};
    run.poses.reserve(end - first);
    for (std::size_t k = first; k < end; ++k)
        run.poses.push_back(path.points[k].location);
    if (path.machine) {
        const auto begin = path.machine->positions.begin();
        run.machine = MachineMotion{path.machine->interpolation,
                                    path.machine->setup,
                                    {begin + static_cast<std::ptrdiff_t>(first),
                                     begin + static_cast<std::ptrdiff_t>(end)}};
    }
    return run;
}

TurningHistory turning_history(const StockHistory& history)
{
    TurningHistory turning{history.block, {}};
    turning.runs.reserve(history.runs.size());
    for (const EarlierRun& run : history.runs) {
        EarlierTurningRun same{CuttingBody{run.cutter}, run.stands_at_first, {}};
        same.poses.reserve(run.tips.size());
        for (const Vec3& tip : run.tips)
            same.poses.push_back({tip, Vec3::UnitZ()});
        turning.runs.push_back(std::move(same));
    }
    return turning;
}

std::size_t motion_count(const TurningHistory& history)
{
    std::size_t count = 0;
    for (const EarlierTurningRun& run : history.runs)
        if (!run.poses.empty())
            count += run.poses.size() - (run.stands_at_first ? 0 : 1);
    return count;
}

JoinedSweeps::JoinedSweeps(const StockHistory* history, const ToolPath& path,
                           const Cutter& cutter)
    : JoinedSweeps{history, path_sweeps(path, cutter), path.points.size()}
{
}

JoinedSweeps::JoinedSweeps(const StockHistory* history,
                           std::span<const StraightSweep> own, std::size_t points)
{
    if (history)
        sweeps_ = history_sweeps(*history);
    earlier_ = sweeps_.size();
    sweeps_.insert(sweeps_.end(), own.begin(), own.end());
    // The first point has no sweep if the path begins with a rapid or a retract.
    first_point_ = static_cast<std::int32_t>(points - own.size());
}

std::int32_t JoinedSweeps::point_of(std::int32_t sweep) const
{
    if (sweep < 0)
        return sweep;
    const auto after = sweep - static_cast<std::int32_t>(earlier_);
    return after < 0 ? by_earlier_run : after + first_point_;
}

}  // namespace endmill
