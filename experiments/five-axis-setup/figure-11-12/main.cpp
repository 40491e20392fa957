// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 11 and 12 of Kang & Suh: the best setup of the teapot for both families, in three modes.
//
//   five-axis-setup-figure-11-12 OUTPUT_FOLDER
//
// Deterministic, under 30 s. Columns and verdicts: README.md beside this.

#include "support/experiment.h"
#include "support/setup_cells.h"
#include "support/setup_pictures.h"

using namespace endmill;

namespace {

CsvTable empty_table()
{
    return CsvTable{{"row", "area_deg2", "floored_area_deg2", "lower_bound_deg2",
                     "phi_from_deg", "phi_to_deg", "theta_from_deg", "theta_to_deg",
                     "tool_x", "tool_y", "tool_z", "leans_to_spout"}};
}

void add_setup(CsvTable& table, const std::string& row, RotaryFamily family,
               const BestSetup& best)
{
    const FittedPose& fit = *best.least;
    const PoseMeasure floored{family, SetupObjective::FlooredArea};
    const Vec3& tool = fit.pose.tool_axis;
    const auto degrees = [](double radians) { return Angle::radians(radians).degrees(); };
    CsvCell bound;
    if (best.lower_bound)
        bound = square_degrees(*best.lower_bound);
    table.add_row({row, square_degrees(fit.area),
                   square_degrees(floored(pose_ranges(family, fit))), bound,
                   degrees(fit.phi.from), degrees(fit.phi.to), degrees(fit.theta.from),
                   degrees(fit.theta.to), tool.x(), tool.y(), tool.z(),
                   tool.x() > 0 ? "yes" : "no"});
}

void draw(Experiment& run, const StudiedPart& part, RotaryFamily family,
          const std::string& mode, const FittedPose& fit)
{
    std::string file = family == RotaryFamily::CA ? "ca-" : "ab-";
    file += mode;
    std::vector<Vec3> nearest;
    if (mode != "set")  // which does not take these for all that matters
        nearest = nearest_directions(part, fit);
    write_setup_pictures(run, file, part, posed(family, fit), nearest);
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(
        argc, argv, "five-axis-setup/figure-11-12", [](Experiment& run) {
            const StudiedPart part =
                studied_part(run.text("mesh"), run.text("grid"),
                             Angle::degrees(run.number("incidence_deg")));
            CsvTable table = empty_table();
            for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB})
                for (const std::string& mode : run.texts("modes")) {
                    const BestSetup best = unlimited_setup(part, family, mode);
                    add_setup(table, family_name(family) + " " + mode, family, best);
                    draw(run, part, family, mode, *best.least);
                }
            run.write_result(table);
        });
}
