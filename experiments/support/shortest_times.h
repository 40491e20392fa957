// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// For benchmarks only: they alone link Google Benchmark.

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

namespace endmill {

/// Time of one execution, the best of all repetitions.
struct WorkTime {
    double cpu_s;   ///< CPU time of the thread
    double wall_s;  ///< wall time
};

/// Keeps the shortest times of each benchmark. The shortest time is the least disturbed
/// by other processes.
class ShortestTimes : public benchmark::BenchmarkReporter {
public:
    /// Prints nothing. \return true, so that the benchmarks run.
    bool ReportContext(const Context& /*context*/) override { return true; }

    /// Called by Google Benchmark after each group of repetitions.
    void ReportRuns(const std::vector<Run>& runs) override
    {
        for (const Run& run : runs) {
            if (run.run_type != Run::RT_Iteration)
                continue;
            const auto count = static_cast<double>(run.iterations);
            const WorkTime time{run.cpu_accumulated_time / count,
                                run.real_accumulated_time / count};
            WorkTime& best =
                shortest_.try_emplace(run.run_name.function_name, time).first->second;
            best = {std::min(best.cpu_s, time.cpu_s), std::min(best.wall_s, time.wall_s)};
        }
    }

    /// \throws std::out_of_range for a benchmark that did not run.
    const WorkTime& of(const std::string& name) const { return shortest_.at(name); }

private:
    std::map<std::string, WorkTime> shortest_;
};

/// Registers a benchmark of `work()`, with five repetitions of half a second each. `work`
/// returns its result, so that the compiler does not remove the work.
template <typename Work>
void add_benchmark(const std::string& name, const Work& work)
{
    const auto body = [work](benchmark::State& state) {
        for (auto _ : state)
            benchmark::DoNotOptimize(work());
    };
    benchmark::RegisterBenchmark(name.c_str(), body)->Repetitions(5)->MinTime(0.5);
}

/// Number of calls in one execution of an `add_calls` benchmark.
inline constexpr int calls_in_a_go = 1024;

/// Registers a benchmark of `evaluate(u, v)` at places spread over [0, range_u] by [0,
/// range_v].
template <typename Evaluate>
void add_calls(const std::string& name, double range_u, double range_v,
               const Evaluate& evaluate)
{
    add_benchmark(name, [=] {
        for (int i = 0; i < calls_in_a_go; ++i)
            benchmark::DoNotOptimize(
                evaluate(range_u * i / calls_in_a_go,
                         range_v * (i * 7 % calls_in_a_go) / calls_in_a_go));
        return 0;
    });
}

/// Runs all registered benchmarks.
inline ShortestTimes shortest_times()
{
    ShortestTimes times;
    benchmark::RunSpecifiedBenchmarks(&times);
    return times;
}

}  // namespace endmill
