// SPDX-License-Identifier: GPL-3.0-or-later
// Speed of surfaces of every kind, of sampling and of reading, with the bars.
//
//   benchmarks-parts OUTPUT_FOLDER
//
// About 20 s; measures time, so nothing else should run. Columns: README.md beside this.

#include <filesystem>

#include "endmill/files/mesh_file.h"
#include "endmill/files/part_file.h"
#include "endmill/surface/nurbs.h"
#include "endmill/surface/sampling.h"
#include "endmill/surface/tool_side.h"
#include "support/experiment.h"
#include "support/shortest_times.h"

using namespace endmill;

namespace {

// A wavy bicubic spline over `spans` by `spans` spans; rational if it has weights.
Surface wavy_spline(int spans, bool rational)
{
    SplineParameter parameter{3, {0, 0, 0}};
    for (int k = 0; k <= spans; ++k)
        parameter.knots.push_back(k);
    parameter.knots.insert(parameter.knots.end(), 3, spans);
    Nurbs nurbs{parameter, parameter, {}, {}};
    for (int j = 0; j < parameter.points(); ++j)
        for (int i = 0; i < parameter.points(); ++i) {
            nurbs.control_points.emplace_back(10 * i, 10 * j, (i * j) % 5);
            if (rational)
                nurbs.weights.push_back(1 + 0.1 * ((i + 2 * j) % 3));
        }
    return nurbs_surface(nurbs);
}

void add_jets(const char* name, const Surface& surface)
{
    const double u = surface.range(Parameter::U).high;
    const double v = surface.range(Parameter::V).high;
    add_calls(name, u, v, [&surface](double s, double t) { return surface.jet(s, t); });
}

std::size_t triangles_of(const PartFile& file)
{
    return std::get<TriangleMesh>(file.part).triangles().size();
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "benchmarks/parts", [](Experiment& run) {
        const int spans = static_cast<int>(run.number("spans"));
        const Surface spline = wavy_spline(spans, false);
        const Surface rational = wavy_spline(spans, true);
        const std::vector<Surface> sheet{dataset_surface(run.text("surface"))};
        const std::vector<double> sides = tool_side_signs(sheet, Vec3::UnitZ());
        const double tolerance = run.number("chord_tolerance_mm");
        const SampledSurface sampling = sampled(sheet, sides, tolerance);
        const auto triangles = static_cast<double>(sampling.mesh.triangles().size());
        const std::filesystem::path file = run.output() / "mesh.stl";
        write_file(file, mesh_text(sampling.mesh, MeshFormat::Stl));

        add_jets("spline", spline);
        add_jets("rational", rational);
        add_benchmark("sampling", [&] {
            return sampled(sheet, sides, tolerance).mesh.points().size();
        });
        add_benchmark("reading", [&] { return triangles_of(read_part(file)); });
        const ShortestTimes times = shortest_times();
        std::filesystem::remove(file);

        CsvTable result{{"row", "triangles", "measured", "unit", "bar", "bar_is"}};
        const auto add_jets_of = [&](const char* row, const char* name) {
            const double measured = 1e-6 * calls_in_a_go / times.of(name).cpu_s;
            result.add_row({row, {}, measured, "million/s", 2, "at least"});
        };
        add_jets_of("jets of a bicubic spline", "spline");
        add_jets_of("jets of a rational one", "rational");
        result.add_row({"sampling", triangles,
                        1e-6 * triangles / times.of("sampling").cpu_s, "million/s", 2,
                        "at least"});
        result.add_row({"reading binary STL", triangles,
                        1e6 / triangles * times.of("reading").cpu_s, "s a million", 0.6,
                        "at most"});
        run.write_result(result);
    });
}
