// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 3 of Park & Maeng: I1 against the slopes across and along the feed, at a depth of the
// ball's radius and a pick feed of half of it.
//
//   ball-end-milling-figure-3 OUTPUT_FOLDER
//
// Deterministic, under 1 s. Columns and verdicts: README.md beside this.

#include "endmill/core/angle.h"
#include "endmill/core/numbers.h"
#include "endmill/process/cutting_coefficients.h"
#include "support/experiment.h"

using namespace endmill;

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "ball-end-milling/figure-3", [](Experiment& run) {
        const double pick_feed = run.number("pick_feed_ratio");
        const double depth = run.number("depth_ratio");
        CsvTable result{{"row", "mu_deg", "lambda_deg", "i1", "i1_exact_chip"}};
        for (const double lambda : run.numbers("lambda_deg"))
            for (const double mu : run.numbers("mu_deg")) {
                const BallEngagement engagement{Angle::degrees(mu).radians(),
                                                Angle::degrees(lambda).radians(),
                                                pick_feed, depth};
                result.add_row({"mu " + to_text(mu) + ", lambda " + to_text(lambda), mu,
                                lambda,
                                cutting_coefficients(engagement, ChipModel::Paper).I1,
                                cutting_coefficients(engagement, ChipModel::Exact).I1});
            }
        run.write_result(result);
    });
}
