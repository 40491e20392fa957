// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 7 of Park & Maeng: the test surface and the cutter's path over it, and the
// length of the path by radius and direction, which the paper does not print.
//
//   ball-end-milling-figure-7 OUTPUT_FOLDER
//
// Deterministic, under 2 s. Columns and verdicts: README.md beside this.

#include <algorithm>
#include <tuple>

#include "ball-end-milling/figure-7/path_figure.h"
#include "endmill/core/text.h"
#include "endmill/figures/tool_path_svg.h"
#include "support/experiment.h"
#include "support/milling_jobs.h"
#include "support/passes_table.h"
#include "support/viewed_passes.h"

using namespace endmill;

namespace {

constexpr double safe_z_mm = 25;

void write_figures(Experiment& run, const OneWayPasses& plan)
{
    const std::string part = run.text("surface");
    const MilledPath milled = milled_path(plan);
    const SurfaceDrawing surface{.figure = {.title = "The test surface"},
                                 .spaces_per_patch = 3};
    run.write("surface.svg", surface_svg(dataset_surface(part), surface));
    run.write("path.svg",
              stroke_path_figure(milled, plan.radius, safe_z_mm,
                                 static_cast<int>(run.number("stroke_pass"))));
    write_passes_for_view(run, plan, milled, "datasets/surfaces/" + part + ".json");
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "ball-end-milling/figure-7", [](Experiment& run) {
        CsvTable result{{"row", "least_z_mm", "greatest_z_mm", "area_mm2", "steepest_deg",
                         "least_radius_mm", "above_stock_percent", "farthest_mm",
                         "passes", "segments", "cl_length_mm", "beside_print_percent"}};
        const OneWayPasses along_x = reference_passes();
        OneWayPasses along_y = along_x;
        // A quarter turn maps the surface onto itself.
        std::swap(along_y.extent.x, along_y.extent.y);
        along_y.samples = 400;
        const double printed = run.number("printed_length_mm");
        const auto add = [&](const std::string& row, OneWayPasses plan, double radius) {
            plan.radius = radius;
            add_named(result, row + ", r0 = " + to_text(radius),
                      path_cells(plan, printed));
        };
        add_named(result, "formula", surface_cells(along_x));
        for (const double radius : run.numbers("radii_mm")) {
            add("along x", along_x, radius);
            add("along y", along_y, radius);
        }
        for (const auto& [name, x, y] :
             {std::tuple{"16 x 12", 16, 12}, {"12 x 16", 12, 16}}) {
            const OneWayPasses meshed = on_mesh(along_x, x, y);
            const int steps = 16 * std::max(x, y);
            add_named(result, std::string{"mesh "} + name,
                      {{"farthest_mm", farthest_apart(along_x.surface, meshed.surface,
                                                      along_x.extent, steps)}});
            add(std::string{"mesh "} + name + ", along x", meshed, along_x.radius);
        }
        run.write_result(result);
        write_figures(run, along_x);
    });
}
