// SPDX-License-Identifier: GPL-3.0-or-later
// Speed and memory of the iso-parametric planner, beside what is asked of them.
//
//   benchmarks-economic-cl-data OUTPUT_FOLDER
//
// About 30 s; measures time, so nothing else should run. Columns: README.md beside this.

#include <filesystem>
#include <limits>

#include "endmill/io/tool_path_csv.h"
#include "support/economy_tables.h"
#include "support/experiment.h"
#include "support/peak_memory.h"
#include "support/shortest_times.h"

using namespace endmill;

namespace {

constexpr int calls = 1024;  // of a short function in one iteration

// Times `evaluate(u, v)` at places spread over u in [0, range_u], v in [0, range_v].
template <typename Evaluate>
void add_calls(const char* name, double range_u, double range_v, Evaluate evaluate)
{
    const auto body = [=](benchmark::State& state) {
        for (auto _ : state)
            for (int i = 0; i < calls; ++i)
                benchmark::DoNotOptimize(
                    evaluate(range_u * i / calls, range_v * (i * 7 % calls) / calls));
    };
    benchmark::RegisterBenchmark(name, body)->Repetitions(5);
}

void add_evaluations(const Surface& surface)
{
    const BezierPatch& patch = surface.patch(1, 0);
    const double u = surface.range(Parameter::U).high;
    const double v = surface.range(Parameter::V).high;
    add_calls("patch jet", 1, 1, [&](double a, double b) { return patch.jet(a, b); });
    add_calls("patch tangents", 1, 1,
              [&](double a, double b) { return patch.tangents(a, b); });
    add_calls("surface jet", u, v, [&](double a, double b) { return surface.jet(a, b); });
    add_calls("surface tangents", u, v,
              [&](double a, double b) { return surface.tangents(a, b); });
}

// A run of the tables with a ball of 15 mm and a tolerance so fine that it has many
// points.
ToolPath long_path(const Surface& surface, double tolerance_mm)
{
    return table_plan(surface, {}, Parameter::U, tolerance_mm, 15).path;
}

void add_runs(const Surface& surface, double fine_mm, const std::filesystem::path& file)
{
    const auto tables = [&](benchmark::State& state) {
        for (auto _ : state)
            benchmark::DoNotOptimize(planned_tables(surface));
    };
    benchmark::RegisterBenchmark("tables", tables)->Repetitions(5);
    const auto million = [&surface, fine_mm, file](benchmark::State& state) {
        for (auto _ : state)
            write_file(file, tool_path_csv(long_path(surface, fine_mm)));
        std::filesystem::remove(file);
    };
    benchmark::RegisterBenchmark("million", million)->Iterations(1)->Repetitions(3);
}

void add_memory(CsvTable& result, const Surface& surface, const char* row,
                double tolerance_mm)
{
    const double points =
        static_cast<double>(long_path(surface, tolerance_mm).points.size());
    const double bytes = peak_memory_bytes([&] { long_path(surface, tolerance_mm); });
    result.add_row({row, points, bytes / points, "bytes a point", {}, {}});
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "benchmarks/economic-cl-data", [](Experiment& run) {
        const Surface surface = dataset_surface(run.text("surface"));
        const double coarse = run.number("tolerance_for_100000_points_mm");
        const double fine = run.number("tolerance_for_1000000_points_mm");
        CsvTable result{{"row", "points", "measured", "unit", "bar", "bar_is"}};
        add_memory(result, surface, "memory of a path", coarse);
        add_memory(result, surface, "memory of a path ten times as long", fine);

        add_evaluations(surface);
        add_runs(surface, fine, run.output() / "million.csv");
        const ShortestTimes times = shortest_times();
        result.add_row({"18 runs of the tables on one core",
                        {},
                        1e3 * times.seconds("tables"),
                        "ms",
                        15.0,
                        "at most"});
        result.add_row({"a million points planned and written",
                        {},
                        times.seconds("million"),
                        "s",
                        2.0,
                        "at most"});
        for (const char* name :
             {"patch jet", "patch tangents", "surface jet", "surface tangents"})
            result.add_row({name,
                            {},
                            1e-6 * calls / times.seconds(name),
                            "million a second",
                            10.0,
                            "at least"});
        run.write_result(result);
    });
}
