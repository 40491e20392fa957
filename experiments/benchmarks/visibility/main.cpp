// SPDX-License-Identifier: GPL-3.0-or-later
// Speed, memory and correctness of visibility maps, with the bars.
//
//   benchmarks-visibility OUTPUT_FOLDER
//
// About 5 minutes; measures time, so nothing else should run. Columns: README.md beside
// this.

#include <bit>

#include "benchmarks/height_parts.h"
#include "benchmarks/visibility/embree_shadows.h"
#include "benchmarks/visibility/exact_rays.h"
#include "endmill/core/parallel.h"
#include "endmill/visibility/sphere_grid.h"
#include "endmill/visibility/visibility.h"
#include "support/experiment.h"
#include "support/peak_memory.h"
#include "support/shortest_times.h"

using namespace endmill;

namespace {

struct Case {
    const char* part;
    int cells;       // of the grid along a side
    int directions;  // evenly chosen from the 1200
    double bar_ns;   // for each pair
};

std::vector<Vec3> some_of(const std::vector<Vec3>& all, int count)
{
    std::vector<Vec3> some;
    some.reserve(count);
    for (int k = 0; k < count; ++k)
        some.push_back(all[k * all.size() / count]);
    return some;
}

double ones(const VisibilityMap& map)
{
    std::size_t count = 0;
    for (std::size_t cell = 0; cell < map.cells(); ++cell)
        for (const std::uint64_t word : map.column(cell))
            count += std::popcount(word);
    return static_cast<double>(count);
}

// While an Embree device exists, it limits oneTBB to its own number of threads. So the
// device is created after our own measurements.
void add_times(CsvTable& result, const Case& each, const std::vector<Vec3>& directions)
{
    const TriangleMesh part = grid_part(each.cells, bumpy_height);
    const VisibilityMap facing =
        part_visibility(part, directions, {.kind = VisibilityKind::Local}).map;
    const auto map = [&](int threads) {
        return [&part, &directions, threads] {
            set_thread_count(threads);
            return part_visibility(part, directions);
        };
    };
    benchmark::ClearRegisteredBenchmarks();
    add_benchmark("one", map(1));
    add_benchmark("two", map(2));
    const ShortestTimes ours = shortest_times();
    EmbreeShadows embree{part};
    benchmark::ClearRegisteredBenchmarks();
    add_benchmark("embree", [&] {
        std::size_t seen = 0;
        for (std::size_t cell = 0; cell < directions.size(); ++cell)
            seen += embree.seen(directions[cell], facing.column(cell));
        return seen;
    });
    const ShortestTimes theirs = shortest_times();
    const auto triangles = static_cast<double>(part.triangles().size());
    const std::string name = each.part;
    const double ns = 1e9 / ones(facing);
    result.add_row({name + ", one thread", triangles, ns * ours.of("one").cpu_s,
                    "ns/pair", each.bar_ns});
    result.add_row({name + ", two threads", triangles,
                    ours.of("one").wall_s / ours.of("two").wall_s, "times as fast", 1.8});
    result.add_row({name + ", Embree, one thread",
                    triangles,
                    ns * theirs.of("embree").cpu_s,
                    "ns/pair",
                    {}});
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "benchmarks/visibility", [](Experiment& run) {
        const std::vector<Vec3> all = sphere_grid("hex:10").centres;
        const auto count = [&](const char* key) {
            return static_cast<int>(run.number(key));
        };
        const std::vector<Case> cases{
            {"10 thousand triangles", 71, count("directions_10_thousand"), 75},
            {"100 thousand triangles", 224, count("directions_100_thousand"), 75},
            {"1 million triangles", 707, count("directions_1_million"), 90}};
        const double bytes = peak_memory_bytes([&] {
            const TriangleMesh part = grid_part(707, bumpy_height);
            part_visibility(part, all);
        });
        CsvTable result{{"row", "triangles", "measured", "unit", "bar"}};
        for (const Case& each : cases)
            add_times(result, each, some_of(all, each.directions));
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
