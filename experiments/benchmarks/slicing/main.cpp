// SPDX-License-Identifier: GPL-3.0-or-later
// Speed of slicing and of offset meshes, with the bars and the times of CGAL.
//
//   benchmarks-slicing OUTPUT_FOLDER
//
// About 40 s; measures time, so nothing else should run. Columns: README.md beside this.

#include "benchmarks/height_parts.h"
#include "benchmarks/slicing/cgal_slices.h"
#include "endmill/core/parallel.h"
#include "endmill/offset/offset_mesh.h"
#include "support/experiment.h"
#include "support/shortest_times.h"

using namespace endmill;

namespace {

std::size_t sliced_points(const TriangleMesh& mesh, const DrivePlanes& planes)
{
    std::size_t count = 0;
    for (const PlaneSection& section : slice(mesh, planes))
        for (const SectionCurve& curve : section.curves)
            count += curve.points.size();
    return count;
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "benchmarks/slicing", [](Experiment& run) {
        const TriangleMesh mesh =
            grid_part(static_cast<int>(run.number("cells")), saddle_height);
        const DrivePlanes planes = drive_planes(DriveFrame{Angle::degrees(0)}, {-40, 40},
                                                static_cast<int>(run.number("planes")));
        CgalSlicer baseline{mesh};
        const std::vector<Surface> part{dataset_surface(run.text("surface"))};
        const Cutter ball = Cutter::ball(run.number("radius_mm"));
        OffsetOptions options{.grid_lines = static_cast<int>(run.number("grid_lines"))};
        const DrivePlanes over_part =
            drive_planes(planes.frame, extent_across(part, planes.frame),
                         static_cast<int>(planes.positions.size()));
        const auto offset = [&](BoundaryContact boundary) {
            options.boundary = boundary;
            return offset_mesh(part, ball, options);
        };
        set_thread_count(1);
        const std::size_t points = sliced_points(mesh, planes);
        const std::size_t baseline_points = baseline.points(planes.positions);
        add_benchmark("slice", [&] { return sliced_points(mesh, planes); });
        add_benchmark("cgal", [&] { return baseline.points(planes.positions); });
        add_benchmark("cgal and tree", [&] {
            baseline.build_tree();
            return baseline.points(planes.positions);
        });
        const ShortestTimes alone = shortest_times();
        benchmark::ClearRegisteredBenchmarks();
        set_thread_count(2);
        add_benchmark("offset",
                      [&] { return offset(BoundaryContact::None).part_triangles; });
        add_benchmark("strips",
                      [&] { return offset(BoundaryContact::Contact).part_triangles; });
        add_benchmark("both", [&] {
            return sliced_points(offset(BoundaryContact::Contact).mesh, over_part);
        });
        const ShortestTimes times = shortest_times();
        CsvTable result{{"row", "points", "measured", "unit", "bar"}};
        const auto add = [&](auto row, const CsvCell& count, double measured, auto unit,
                             const CsvCell& bar) {
            result.add_row({row, count, measured, unit, bar});
        };
        constexpr double ms = 1e3;
        const double own = alone.of("slice").cpu_s;
        const double other = alone.of("cgal").cpu_s;
        const double with_tree = alone.of("cgal and tree").cpu_s;
        add("slicing the saddle", static_cast<double>(points), ms * own, "ms",
            "at most 13");
        add("by CGAL, tree given", static_cast<double>(baseline_points), ms * other, "ms",
            {});
        add("by CGAL, tree built", {}, ms * with_tree, "ms", {});
        add("CGAL to ours", {}, with_tree / own, "times", {});
        add("offset, no strips", {}, ms * times.of("offset").wall_s, "ms", {});
        add("offset with strips", {}, ms * times.of("strips").wall_s, "ms", {});
        add("the same and sliced", {}, ms * times.of("both").wall_s, "ms", {});
        run.write_result(result);
    });
}
