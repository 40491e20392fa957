// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 11 and 12 of Kang & Suh: the best setup of the teapot for both families, in three modes.
//
//   five-axis-setup-figure-11-12 OUTPUT_FOLDER
//
// Deterministic, under 30 s. Columns and verdicts: README.md beside this.

#include "five-axis-setup/figure-11-12/setup_pictures.h"
#include "support/experiment.h"
#include "support/setup_cells.h"

using namespace endmill;

namespace {

CsvTable empty_table()
{
    return CsvTable{{"row", "area_deg2", "floored_area_deg2", "lower_bound_deg2",
                     "phi_s_deg", "phi_l_deg", "theta_s_deg", "theta_l_deg", "width_deg",
                     "tilt_deg", "azimuth_deg", "axis_x", "axis_y", "axis_z",
                     "leans_to_x"}};
}

void add_setup(CsvTable& table, const std::string& row, RotaryFamily family,
               const PartSetup& best)
{
    const FittedPose& fit = *best.least;
    const PoseMeasure floored{family, SetupObjective::FlooredArea};
    NamedCells cells{
        {"floored_area_deg2", square_degrees(floored(pose_ranges(family, fit)))}};
    if (best.certificate)
        cells.emplace_back("lower_bound_deg2",
                           square_degrees(best.certificate->lower_bound));
    cells = joined(cells, range_cells(family, fit));
    add_named(table, row, joined(cells, axis_cells(fit.pose.tool_axis)));
}

void draw(Experiment& run, const StudiedPart& part, RotaryFamily family,
          const std::string& mode, const FittedPose& fit)
{
    const bool is_ca = family == RotaryFamily::CA;
    const SetupPictureNames names{.file = (is_ca ? "ca-" : "ab-") + mode,
                                  .title = family_name(family) + ", mode " + mode,
                                  .captions = {range_caption(family, fit)}};
    std::vector<Vec3> nearest;
    if (mode != "set")  // `set` uses all directions of a cone, not these alone
        nearest = nearest_directions(part, fit);
    write_setup_pictures(run, names, part, posed(family, fit), nearest);
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
                    const PartSetup best = unlimited_setup(part, family, mode);
                    add_setup(table, family_name(family) + " " + mode, family, best);
                    draw(run, part, family, mode, *best.least);
                }
            run.write_result(table);
        });
}
