// SPDX-License-Identifier: GPL-3.0-or-later
// Speed and memory of the drop cutter on meshes, with the bars.
//
//   benchmarks-drop-cutter OUTPUT_FOLDER
//
// About 60 s; measures time, so nothing else should run. Columns: README.md beside this.

#include "benchmarks/height_parts.h"
#include "endmill/core/parallel.h"
#include "endmill/drop_cutter/drop_cutter.h"
#include "support/experiment.h"
#include "support/peak_memory.h"
#include "support/shortest_times.h"

using namespace endmill;

namespace {

struct Case {
    const char* row;
    int cells;
    double (*height)(double x, double y);
    Cutter cutter;
    CsvCell bar;
};

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "benchmarks/drop-cutter", [](Experiment& run) {
        const double R = run.number("radius_mm");
        const Cutter bull{R, run.number("corner_radius_mm")};
        const std::vector<Case> cases{
            {"ball, saddle, 20 thousand triangles",
             100,
             saddle_height,
             Cutter::ball(R),
             {}},
            {"ball, saddle", 300, saddle_height, Cutter::ball(R), 1},
            {"ball, bumpy", 300, bumpy_height, Cutter::ball(R), 0.4},
            {"ball, saddle, 2 million triangles", 1000, saddle_height, Cutter::ball(R),
             0.25},
            {"flat, saddle", 300, saddle_height, Cutter::flat(R), {}},
            {"bull-nose, saddle", 300, saddle_height, bull, 0.04},
            {"bull-nose, bumpy", 300, bumpy_height, bull, 0.04}};
        const double bytes = peak_memory_bytes([&] {
            const TriangleMesh mesh = grid_part(1000, saddle_height);
            DropCutter{mesh, Cutter::ball(R)}.contact({0, 0});
        });
        const auto path = zigzag_path(static_cast<int>(run.number("lines")),
                                      static_cast<int>(run.number("steps")));
        CsvTable result{{"row", "triangles", "measured", "unit", "bar"}};
        set_thread_count(1);
        for (const Case& each : cases) {
            const TriangleMesh mesh = grid_part(each.cells, each.height);
            const DropCutter drop_cutter{mesh, each.cutter};
            benchmark::ClearRegisteredBenchmarks();
            add_benchmark("drop", [&] { return drop_cutter.tip_heights(path); });
            const double s = shortest_times().of("drop").cpu_s;
            const double points = static_cast<double>(path.size());
            result.add_row({each.row, static_cast<double>(mesh.triangles().size()),
                            1e-6 * points / s, "million points/s", each.bar});
        }
        result.add_row({"ball, saddle, with the mesh", 2e6, 1e-6 * bytes, "MB", 150});
        run.write_result(result);
    });
}
