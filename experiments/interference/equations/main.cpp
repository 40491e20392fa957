// SPDX-License-Identifier: GPL-3.0-or-later
// Equations (1) to (5) of Jang, Kim and Jeong as printed and as corrected: distance and
// angle of the offset point against the tangent of the part.
//
//   interference-equations OUTPUT_FOLDER
//
// Deterministic, under 1 s. Columns and verdicts: README.md beside this.

#include <algorithm>

#include "endmill/core/text.h"
#include "interference/equations/equation_errors.h"
#include "support/experiment.h"
#include "support/named_cells.h"

using namespace endmill;

namespace {

void add_curve_rows(Experiment& run, CsvTable& result)
{
    NormalErrors worst_printed{};
    NormalErrors worst_corrected{};
    for (const double degrees : run.numbers("slopes_deg")) {
        const Angle slope = Angle::degrees(degrees);
        const NormalErrors printed = printed_normal_errors(slope);
        const NormalErrors corrected = corrected_normal_errors(slope);
        add_named(result, "eq (1) and (2) as printed, slope " + to_text(degrees) + " deg",
                  {{"angle_error_deg", printed.angle_deg},
                   {"distance_error_share", printed.distance_share}});
        worst_printed = worse(worst_printed, printed);
        worst_corrected = worse(worst_corrected, corrected);
    }
    for (const auto& [name, worst] : {std::pair{"as printed", worst_printed},
                                      std::pair{"corrected", worst_corrected}})
        add_named(result, std::string{"eq (1) and (2) "} + name + ", all slopes",
                  {{"angle_error_deg", worst.angle_deg},
                   {"distance_error_share", worst.distance_share}});
    const double x = run.number("x_mm");
    add_named(result, "eq (2), left side as printed",
              {{"left_side_error_mm", left_side_error(x, run.number("radius_mm"))}});
}

void add_cutter_rows(Experiment& run, CsvTable& result)
{
    const Surface surface = dataset_surface(run.text("surface"));
    const int lines = static_cast<int>(run.number("grid_lines"));
    const double radius = run.number("radius_mm");
    const std::vector<SurfaceTangents> grid = tangents_on_grid(surface, lines);
    const std::pair<const char*, Cutter> cutters[]{
        {"ball", Cutter::ball(radius)},
        {"bull-nose", {radius, run.number("corner_radius_mm")}},
        {"flat", Cutter::flat(radius)}};
    for (const auto& [name, cutter] : cutters)
        add_named(result, std::string{"eq (3), "} + name,
                  {{"gap_in_plane_mm", gap_in_plane(cutter)},
                   {"gap_in_space_mm", gap_in_space(cutter, grid)},
                   {"distance_spread_share", distance_spread(cutter, grid)}});
    add_named(result, "eq (3), flat, without normal",
              {{"gouge_mm", gouge_without_normal(radius, grid)}});
    add_named(result, "eq (5)", {{"tangent_component", tangent_component(grid)}});
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "interference/equations", [](Experiment& run) {
        CsvTable result{{"row", "angle_error_deg", "distance_error_share",
                         "left_side_error_mm", "gap_in_plane_mm", "gap_in_space_mm",
                         "distance_spread_share", "gouge_mm", "tangent_component"}};
        add_curve_rows(run, result);
        add_cutter_rows(run, result);
        run.write_result(result);
    });
}
