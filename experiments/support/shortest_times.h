// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// For benchmarks only: they alone link Google Benchmark.

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

namespace endmill {

/// Keeps the shortest time of each benchmark over its repetitions: what the machine can
/// do when nothing else gets in the way.
class ShortestTimes : public benchmark::BenchmarkReporter {
public:
    /// Nothing is printed. \return true: go on.
    bool ReportContext(const Context& /*context*/) override { return true; }

    /// Called by Google Benchmark after each group of repetitions.
    void ReportRuns(const std::vector<Run>& runs) override
    {
        for (const Run& run : runs) {
            if (run.run_type != Run::RT_Iteration)
                continue;
            const double seconds =
                run.real_accumulated_time / static_cast<double>(run.iterations);
            double& shortest =
                shortest_.try_emplace(run.run_name.function_name, seconds).first->second;
            shortest = std::min(shortest, seconds);
        }
    }

    /// Of one iteration, in s. \throws std::out_of_range for a name that did not run.
    double seconds(const std::string& name) const { return shortest_.at(name); }

private:
    std::map<std::string, double> shortest_;
};

/// Runs all registered benchmarks, each for at least half a second a repetition.
inline ShortestTimes shortest_times()
{
    std::string program = "benchmark";
    std::string time = "--benchmark_min_time=0.5";
    char* arguments[] = {program.data(), time.data()};
    int count = 2;
    benchmark::Initialize(&count, arguments);
    ShortestTimes times;
    benchmark::RunSpecifiedBenchmarks(&times);
    return times;
}

}  // namespace endmill
