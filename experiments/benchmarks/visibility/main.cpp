// SPDX-License-Identifier: GPL-3.0-or-later
// Speed, memory and correctness of visibility maps, with the bars.
//
//   benchmarks-visibility OUTPUT_FOLDER
//
// About 5 minutes; measures time, so nothing else should run. Columns: README.md beside
// this.

#include "benchmarks/height_parts.h"
#include "benchmarks/visibility/exact_rays.h"
#include "benchmarks/visibility/map_times.h"
#include "endmill/visibility/sphere_grid.h"
#include "support/experiment.h"
#include "support/peak_memory.h"

using namespace endmill;

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "benchmarks/visibility", [](Experiment& run) {
        const std::vector<Vec3> all = sphere_grid("hex:10").centres;
        const auto count = [&](const char* key) {
            return static_cast<int>(run.number(key));
        };
        const std::vector<MapCase> cases{
            {"10 thousand triangles", 71, count("directions_10_thousand"), 75},
            {"100 thousand triangles", 224, count("directions_100_thousand"), 75},
            {"1 million triangles", 707, count("directions_1_million"), 90}};
        const double bytes = peak_memory_bytes([&] {
            const TriangleMesh part = grid_part(707, bumpy_height);
            part_visibility(part, all);
        });
        CsvTable result{{"row", "triangles", "measured", "unit", "bar"}};
        for (const MapCase& each : cases)
            add_map_times(result, each, all);
        result.add_row({"1 million triangles along all 1200, with the part",
                        999698,
                        1e-6 * bytes,
                        "MB",
                        {}});
        const TriangleMesh judged = grid_part(71, bumpy_height);
        result.add_row({"disagreements with exact rays, random pairs",
                        static_cast<double>(judged.triangles().size()),
                        static_cast<double>(disagreements(judged, all, count("pairs"))),
                        "pairs", 0});
        run.write_result(result);
    });
}
