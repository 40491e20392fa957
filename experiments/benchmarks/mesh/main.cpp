// SPDX-License-Identifier: GPL-3.0-or-later
// Speed and memory of triangle meshes, with the bars.
//
//   benchmarks-mesh OUTPUT_FOLDER
//
// About 35 s; measures time, so nothing else should run. Columns: README.md beside this.

#include <array>
#include <cmath>
#include <optional>

#include "benchmarks/height_parts.h"
#include "endmill/core/text.h"
#include "endmill/mesh/detail/weld.h"
#include "endmill/mesh/mesh_checks.h"
#include "endmill/mesh/triangle_tree.h"
#include "support/experiment.h"
#include "support/peak_memory.h"
#include "support/shortest_times.h"

using namespace endmill;

namespace {

constexpr int scattered_places = 10'000;
// mm over the mesh
constexpr std::array scattered_heights{0.1, 1.0, 10.0, 100.0};

// Nearest points to places 0.006 mm apart at a height over the middle of the mesh. Each
// search starts from the answer to the previous one.
double walk_over(const TriangleTree& tree, double middle_mm, double above_mm)
{
    std::optional<std::size_t> hint;
    double sum = 0;
    for (int k = 0; k < calls_in_a_go; ++k) {
        const double x = middle_mm + 0.006 * k;
        const double y = middle_mm / 2 + 0.001 * k;
        const auto found = tree.nearest({x, y, wavy_height(x, y) + above_mm}, hint);
        hint = found->triangle;
        sum += found->distance;
    }
    return sum;
}

// Nearest points to places at a height that are far from each other, so that a search
// finds little of the tree in the nearest caches.
double search_scattered(const TriangleTree& tree, double along_mm, double above_mm)
{
    double sum = 0;
    for (int k = 0; k < scattered_places; ++k) {
        // Multiples of the powers of the plastic number cover the square evenly.
        const double x = along_mm * std::fmod(0.7548776662466927 * k, 1);
        const double y = along_mm / 2 * std::fmod(0.5698402909980532 * k, 1);
        sum += tree.nearest({x, y, wavy_height(x, y) + above_mm})->distance;
    }
    return sum;
}

double cast_down(const TriangleTree& tree, double middle_mm)
{
    double sum = 0;
    for (double x = middle_mm; x < middle_mm + 0.006 * (calls_in_a_go - 0.5); x += 0.006)
        sum += tree.first_hit({{x, middle_mm / 2, 9}, {0.1, 0.2, -1}})->t;
    return sum;
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "benchmarks/mesh", [](Experiment& run) {
        const auto along = static_cast<std::int32_t>(run.number("cells_along"));
        const double cell_mm = run.number("cell_mm");
        const double bytes = peak_memory_bytes([&] { wavy_part(along, cell_mm); });
        const TriangleMesh mesh = wavy_part(along, cell_mm);
        const auto soup = soup_of(mesh);
        const TriangleTree tree{mesh};
        const double along_mm = along * cell_mm;
        const double middle_mm = along_mm / 2;
        add_benchmark("weld", [&] { return weld(soup).welded_points; });
        add_benchmark("checks", [&] { return mesh_report(mesh).components; });
        add_benchmark("tree", [&] { return TriangleTree{mesh}.nearest({0, 0, 0}); });
        add_benchmark("near", [&] { return walk_over(tree, middle_mm, 0.1); });
        add_benchmark("far", [&] { return walk_over(tree, middle_mm, 1); });
        for (const double above : scattered_heights)
            add_benchmark("scattered " + to_text(above), [&tree, along_mm, above] {
                return search_scattered(tree, along_mm, above);
            });
        add_benchmark("ray", [&] { return cast_down(tree, middle_mm); });
        const ShortestTimes times = shortest_times();
        const auto triangles = static_cast<double>(mesh.triangles().size());
        CsvTable result{{"row", "triangles", "measured", "unit", "bar_at_most"}};
        const auto add = [&](auto row, double measured, auto unit, const CsvCell& bar) {
            result.add_row({row, triangles, measured, unit, bar});
        };
        constexpr double us = 1e6 / calls_in_a_go;
        add("a mesh", bytes / triangles, "bytes a triangle", 60);
        add("welding its triangles", times.of("weld").cpu_s, "s", 0.25);
        add("its checks", times.of("checks").cpu_s, "s", 0.15);
        add("its tree", times.of("tree").cpu_s, "s", {});
        add("nearest point, 0.1 mm away", us * times.of("near").cpu_s, "us", 3);
        add("nearest point, 1 mm away", us * times.of("far").cpu_s, "us", 3);
        for (const double above : scattered_heights)
            add("nearest point to a scattered place, " + to_text(above) + " mm away",
                1e6 / scattered_places * times.of("scattered " + to_text(above)).cpu_s,
                "us", above <= 1 ? CsvCell{3} : CsvCell{});
        add("first hit of a ray", us * times.of("ray").cpu_s, "us", {});
        run.write_result(result);
    });
}
