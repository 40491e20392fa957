// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "benchmarks/simulation/default_net.h"
#include "support/experiment.h"
#include "support/peak_memory.h"
#include "support/shortest_times.h"

namespace endmill {

/// A planner of the default net with its path.
struct NetMode {
    std::string name;
    Planner planner;
    ToolPath path;
    double peak_bytes;  ///< memory to plan and verify
};

/// The paper's planner, then the verified one. Measures the memory in child processes,
/// which must be forked before this process has threads.
/// \param pitch of the stock, mm.
inline std::vector<NetMode> net_modes(const DefaultNet& net, double pitch)
{
    std::vector<NetMode> modes{{"paper", Planner::Paper, {}, 0},
                               {"verified", Planner::Verified, {}, 0}};
    for (NetMode& mode : modes)
        mode.peak_bytes = peak_memory_bytes(
            [&] { net.verified(net.planned(mode.planner).path, pitch); });
    for (NetMode& mode : modes)
        mode.path = net.planned(mode.planner).path;
    return modes;
}

/// Registers a benchmark of planning and one of verification for each of `modes`, which
/// must outlive the benchmarks.
inline void add_net_benchmarks(const DefaultNet& net, const std::vector<NetMode>& modes,
                               double pitch)
{
    for (const NetMode& mode : modes) {
        add_benchmark(mode.name + " plan", [&net, &mode] {
            return net.planned(mode.planner).path.points.size();
        });
        add_benchmark(mode.name + " judged",
                      [&net, &mode, pitch] { return net.verified(mode.path, pitch); });
    }
}

/// Adds the time and the memory of each mode, and the ratio of the planning times.
inline void add_net_rows(CsvTable& result, const std::vector<NetMode>& modes,
                         const ShortestTimes& times, double pitch)
{
    constexpr double gib = 1024.0 * 1024 * 1024;
    for (const NetMode& mode : modes) {
        const std::string row = "default net, " + mode.name + " path, judged";
        const auto points = static_cast<double>(mode.path.points.size());
        const double judged_s = times.of(mode.name + " judged").wall_s;
        result.add_row({row, pitch, points, judged_s, "s", 5});
        result.add_row(
            {row + ", memory", pitch, points, mode.peak_bytes / gib, "GiB", 2});
    }
    result.add_row({"default net, verified plan by paper plan, both measured",
                    {},
                    static_cast<double>(modes.back().path.points.size()),
                    times.of("verified plan").wall_s / times.of("paper plan").wall_s,
                    "times",
                    3});
}

}  // namespace endmill
