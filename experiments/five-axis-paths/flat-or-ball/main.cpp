// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts of flat, bull-nose and ball cutters of one diameter on a convex part.
//
//   five-axis-paths-flat-or-ball OUTPUT_FOLDER
//
// Deterministic, about two minutes. Columns and verdicts: README.md beside this.

#include <cstdint>
#include <string>

#include "endmill/core/text.h"
#include "endmill/orientation/oriented_path.h"
#include "endmill/surface/nurbs.h"
#include "support/experiment.h"

using namespace endmill;

namespace {

// The paraboloid z = -depth (x^2 + y^2) / side^2 over a square, an elliptic and convex part.
Surface paraboloid(double side, double depth)
{
    std::vector<Vec3> net;
    for (const double x : {-1.0, 0.0, 1.0})
        for (const double y : {-1.0, 0.0, 1.0}) {
            // blossoms of x^2 and y^2 at (-1, -1), (-1, 1), (1, 1)
            const double x2 = x == 0 ? -1 : 1;
            const double y2 = y == 0 ? -1 : 1;
            net.emplace_back(side * x, side * y, -depth * (x2 + y2));
        }
    return nurbs_surface({{2, {0, 0, 0, 1, 1, 1}}, {2, {0, 0, 0, 1, 1, 1}}, net, {}});
}

}  // namespace

int main(int argc, char** argv)
{
    const std::string name = "five-axis-paths/flat-or-ball";
    return run_experiment(argc, argv, name, [](Experiment& run) {
        const std::vector<Surface> part{
            paraboloid(run.number("half_side_mm"), run.number("depth_mm"))};
        const double radius = run.number("radius_mm");
        const std::vector<double> leads = run.numbers("leads_deg");
        CsvTable result{{"row", "corner_radius_mm", "lead_deg", "passes", "points",
                         "narrowest_strip_mm", "cut_mm", "left_mm", "verdict"}};
        OrientedOptions options;
        options.scallop_height = run.number("scallop_mm");
        options.inner_tolerance = run.number("inner_tolerance_mm");
        options.safe_height = 20;
        for (const double corner : run.numbers("corner_radii_mm"))
            for (const double lead : leads) {
                options.mode = AxisMode::Fixed;
                options.inclination.lead = Angle::degrees(lead);
                const Cutter cutter{radius, corner};
                const auto [plan, verification] =
                    plan_judged_oriented(part, cutter, options);
                result.add_row({cutter_word(cutter) + ", lead " + to_text(lead), corner,
                                lead, static_cast<std::int64_t>(plan.passes),
                                static_cast<std::int64_t>(plan.path.points.size()),
                                plan.narrowest_strip_mm, plan.cut_contact_mm,
                                verification.on_part.value().deviation.max_scallop_mm,
                                std::string{verdict_name(verification.verdict)}});
            }
        run.write_result(result);
    });
}
