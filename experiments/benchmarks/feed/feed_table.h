// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "support/experiment.h"
#include "support/shortest_times.h"

namespace endmill {

/// The results of all benchmarks of a feed plan with their bars.
/// \param few_segments number of segments of the path of `torque`, `direct` and `stock`.
/// \param program_segments number of segments of the path of `program`.
inline CsvTable feed_table(const ShortestTimes& times, std::size_t few_segments,
                           std::size_t program_segments)
{
    // 20 s for a program of 5.8 million moves.
    constexpr double s_a_million = 20 / 5.8;
    CsvTable result{{"row", "measured", "unit", "bar_at_most", "bar_at_least"}};
    const auto add = [&](const std::string& row, double measured, const char* unit,
                         const CsvCell& at_most = {}, const CsvCell& at_least = {}) {
        result.add_row({row, measured, unit, at_most, at_least});
    };
    const auto wall = [&](const std::string& name) { return times.of(name).wall_s; };
    add("whole, two threads", wall("whole, two"), "s", 1);
    add("whole, one thread", wall("whole, one"), "s");
    add("one over two threads", wall("whole, one") / wall("whole, two"), "1", {}, 1.8);
    add("100 over 10 thousand segments", wall("whole, one") / wall("tenth, one"), "1",
        12);
    const double million = 1e-6 * static_cast<double>(program_segments);
    add("long program, two threads", wall("program, two") / million,
        "s a million segments", s_a_million);
    add("long program, one thread", wall("program, one") / million,
        "s a million segments");
    for (const char* part :
         {"read", "geometry", "feeds", "feeds by the table", "motion", "write"})
        add(part, times.of(part).cpu_s, "s");
    const double ms_a_segment = 1000 / static_cast<double>(few_segments);
    for (const char* peak : {"torque", "direct"})
        add(peak, ms_a_segment * times.of(peak).cpu_s, "ms a segment", 1);
    for (const std::string stock : {"stock", "stock, direct"}) {
        const double one = wall(stock + ", one");
        add(stock, ms_a_segment * one, "ms a segment");
        add(stock + ", one over two threads", one / wall(stock + ", two"), "1");
    }
    return result;
}

}  // namespace endmill
