// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 2 of Park & Maeng for one case: the engaged part E of the half sphere, which
// faces the feed and lies outside the previous pass.
//
//   ball-end-milling-figure-2 OUTPUT_FOLDER
//
// Deterministic, under 1 s. Columns and verdicts: README.md beside this.

#include "ball-end-milling/figure-2/tables.h"
#include "endmill/core/angle.h"
#include "endmill/core/text.h"
#include "endmill/figures/force_figures.h"
#include "endmill/process/cutting_coefficients.h"
#include "support/experiment.h"

using namespace endmill;

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "ball-end-milling/figure-2", [](Experiment& run) {
        const Angle mu = Angle::degrees(run.number("mu_deg"));
        const Angle lambda = Angle::degrees(run.number("lambda_deg"));
        const BallEngagement engagement{mu.radians(), lambda.radians(),
                                        run.number("pick_feed_ratio"),
                                        run.number("depth_ratio")};
        const BallFrame frame{Milling::Down, run.number("radius_mm")};
        const int samples = static_cast<int>(run.number("azimuths"));
        CsvTable result{{"row", "ranges", "from_deg", "to_deg", "engaged_deg",
                         "sampled_deg", "i6", "i6_by_ranges"}};
        for (const double latitude : run.numbers("latitudes_deg"))
            add_named(
                result, "latitude " + to_text(latitude),
                latitude_cells(engagement, Angle::degrees(latitude).radians(), samples));
        add_named(
            result, "ball",
            {{"i6", cutting_coefficients(engagement).I6},
             {"i6_by_ranges",
              i6_by_ranges(engagement, static_cast<int>(run.number("latitude_steps")))}});
        run.write_result(result);
        run.write("borders.csv",
                  border_table(engagement_borders(engagement), frame.radius_mm).text());
        run.write("engagement.svg",
                  engagement_svg(
                      engagement, frame,
                      {"μ = " + to_text(run.number("mu_deg")) +
                       "°, λ = " + to_text(run.number("lambda_deg")) +
                       "°, f_p = " + to_text(engagement.pick_feed_ratio) +
                       " r0, l = " + to_text(engagement.depth_ratio) +
                       " r0; milling down, r0 = " + to_text(frame.radius_mm) + " mm"}));
    });
}
