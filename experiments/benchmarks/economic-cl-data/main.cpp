// SPDX-License-Identifier: GPL-3.0-or-later
// Speed and memory of the iso-parametric planner, with the bars.
//
//   benchmarks-economic-cl-data OUTPUT_FOLDER
//
// About 40 s; measures time, so nothing else should run. Columns: README.md beside this.

#include <filesystem>

#include "endmill/core/text.h"
#include "endmill/files/path_file.h"
#include "support/experiment.h"
#include "support/peak_memory.h"
#include "support/printed_tables.h"
#include "support/shortest_times.h"

using namespace endmill;

namespace {

ToolPath path_of(const Surface& surface, double tolerance_mm)
{
    return table_plan(surface, {}, Parameter::U, tolerance_mm, /*diameter_mm=*/15).path;
}

void add_memory(CsvTable& result, const Surface& surface, double tolerance_mm)
{
    const auto points = static_cast<double>(path_of(surface, tolerance_mm).points.size());
    const double bytes = peak_memory_bytes([&] { path_of(surface, tolerance_mm); });
    const std::string row = "path at " + to_text(tolerance_mm) + " mm";
    result.add_row({row, points, bytes / points, "bytes a point", {}, {}});
}

void add_benchmarks(const Surface& surface, double fine_mm,
                    const std::filesystem::path& file)
{
    const double range_u = surface.range(Parameter::U).high;
    const double range_v = surface.range(Parameter::V).high;
    const auto jet = [&](double u, double v) { return surface.jet(u, v); };
    const auto tangents = [&](double u, double v) { return surface.tangents(u, v); };
    const BezierPatch& patch = surface.patch(1, 0);
    add_calls("jet of a surface", range_u, range_v, jet);
    add_calls("tangents of a surface", range_u, range_v, tangents);
    add_calls("jet of a patch", 1, 1,
              [&](double u, double v) { return patch.jet(u, v); });
    add_benchmark("tables", [&] { return planned_tables(surface); });
    add_benchmark("million", [&surface, fine_mm, file] {
        write_file(file, tool_path_csv(path_of(surface, fine_mm)));
        return std::filesystem::remove(file);
    });
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "benchmarks/economic-cl-data", [](Experiment& run) {
        const Surface surface = dataset_surface(run.text("surface"));
        const double fine = run.number("tolerance_for_1000000_points_mm");
        CsvTable result{{"row", "points", "measured", "unit", "bar", "bar_is"}};
        add_memory(result, surface, run.number("tolerance_for_100000_points_mm"));
        add_memory(result, surface, fine);
        add_benchmarks(surface, fine, run.output() / "million.csv");
        const ShortestTimes times = shortest_times();
        const auto add = [&](const char* row, double measured, const char* unit,
                             double bar) {
            const char* sense =
                std::string_view{unit} == "million/s" ? "at least" : "at most";
            result.add_row({row, {}, measured, unit, bar, sense});
        };
        add("18 runs of the tables", 1e3 * times.of("tables").cpu_s, "ms", 15);
        add("a million points to a CSV file", times.of("million").wall_s, "s", 2);
        for (const char* row :
             {"jet of a patch", "jet of a surface", "tangents of a surface"})
            add(row, 1e-6 * calls_in_a_go / times.of(row).cpu_s, "million/s", 10);
        run.write_result(result);
    });
}
