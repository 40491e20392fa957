// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "benchmarks/height_parts.h"
#include "benchmarks/visibility/embree_shadows.h"
#include "endmill/core/parallel.h"
#include "endmill/visibility/visibility.h"
#include "support/experiment.h"
#include "support/shortest_times.h"

namespace endmill {

/// A part with bumps and the directions along which its visibility is computed.
struct MapCase {
    const char* part;  ///< label
    int cells;         ///< of the grid along a side
    int directions;    ///< evenly chosen from all
    double bar_ns;     ///< for each pair of a facet and a direction that it faces
    double bar_of_embree = 0.55;  ///< largest share of Embree's time
};

/// `count` directions, evenly chosen from `all`.
inline std::vector<Vec3> some_of(const std::vector<Vec3>& all, int count)
{
    std::vector<Vec3> some;
    some.reserve(count);
    for (int k = 0; k < count; ++k)
        some.push_back(all[k * all.size() / count]);
    return some;
}

/// Number of pairs that `map` holds.
inline double ones(const VisibilityMap& map)
{
    std::size_t count = 0;
    for (std::size_t cell = 0; cell < map.cells(); ++cell)
        for (const std::uint64_t word : map.column(cell))
            count += std::popcount(word);
    return static_cast<double>(count);
}

/// Adds the times a pair on one thread, on two threads and by Embree. While an Embree
/// device exists, it limits oneTBB to its own number of threads. So the device is created
/// after our own measurements.
inline void add_map_times(CsvTable& result, const MapCase& each,
                          const std::vector<Vec3>& all)
{
    const std::vector<Vec3> directions = some_of(all, each.directions);
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
    result.add_row({name + ", one thread, as a share of Embree's time", triangles,
                    ours.of("one").cpu_s / theirs.of("embree").cpu_s, "of its time",
                    each.bar_of_embree});
}

}  // namespace endmill
