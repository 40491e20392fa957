// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 2 and 11 of Kim & Choi: the example surface and the tangent continuity of its
// net. The net is not printed; one fitted to the tables is drawn and measured instead.
//
//   economic-cl-data-figure-2-11 OUTPUT_FOLDER
//
// Deterministic, under 1 s. Columns and verdicts: README.md beside this.

#include <cstdint>

#include "endmill/figures/tool_path_svg.h"
#include "endmill/surface/detail/tangent_condition.h"
#include "endmill/surface/extent.h"
#include "support/experiment.h"

using namespace endmill;

namespace {

void add_size(CsvTable& result, const Surface& surface)
{
    result.add_row({"size",
                    static_cast<std::int64_t>(surface.patches(Parameter::U)),
                    static_cast<std::int64_t>(surface.patches(Parameter::V)),
                    extent(surface, Vec3::UnitX()).length(),
                    extent(surface, Vec3::UnitY()).length(),
                    extent(surface, Vec3::UnitZ()).length(),
                    {},
                    {},
                    {},
                    {},
                    {}});
}

void add_border(CsvTable& result, const TangentCondition& condition)
{
    result.add_row({condition.border,
                    {},
                    {},
                    {},
                    {},
                    {},
                    condition.measured.gap_mm,
                    condition.measured.normals.radians(),
                    condition.least_ratio,
                    condition.greatest_ratio,
                    condition.worst_bend.radians()});
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(
        argc, argv, "economic-cl-data/figure-2-11", [](Experiment& run) {
            const std::string name = run.text("surface");
            const Surface surface = dataset_surface(name);
            CsvTable result{{"row", "patches_u", "patches_v", "width_mm", "depth_mm",
                             "height_mm", "gap_mm", "normals_apart_rad",
                             "leg_ratio_least", "leg_ratio_greatest", "leg_bend_rad"}};
            add_size(result, surface);
            for (const TangentCondition& condition : tangent_conditions(surface))
                add_border(result, condition);
            run.write_result(result);

            SurfaceDrawing drawing;
            drawing.figure.title = "Example surface: " + name;
            drawing.figure.captions = {"3 x 2 bicubic patches, 200 x 120 x 220 mm"};
            run.write("surface.svg", surface_svg(surface, drawing));
            drawing.control_net = true;
            drawing.figure.title = "Control net of " + name;
            run.write("control-net.svg", surface_svg(surface, drawing));
        });
}
