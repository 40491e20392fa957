// SPDX-License-Identifier: GPL-3.0-or-later
// The printed equations of Park & Maeng against their definitions, and the consequences
// that the text draws from them.
//
//   ball-end-milling-equations OUTPUT_FOLDER
//
// Deterministic, under 10 s. Columns and verdicts: README.md beside this.

#include "ball-end-milling/equations/printed_forces.h"
#include "ball-end-milling/equations/printed_geometry.h"
#include "ball-end-milling/equations/printed_limits.h"
#include "support/experiment.h"
#include "support/milling_jobs.h"

using namespace endmill;

namespace {

std::vector<BallEngagement> engagements(Experiment& run)
{
    const auto mu = run.numbers("mu");
    const auto lambda = run.numbers("lambda");
    const auto pick = run.numbers("pick_feed_ratio");
    const auto depth = run.numbers("depth_ratio");
    std::vector<BallEngagement> all;
    for (std::size_t i = 0; i < mu.size(); ++i)
        all.push_back({mu[i], lambda.at(i), pick.at(i), depth.at(i)});
    return all;
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "ball-end-milling/equations", [](Experiment& run) {
        CsvTable result{{"row", "deviation", "constant", "change_percent", "wear_ratio"}};
        const MillingJob job = reference_job(run.text("material"));
        const double feed = run.number("feed_per_tooth_mm");
        const auto cuts = engagements(run);
        add_force_equations(result, cuts, job, feed);
        add_printed_limits(result, cuts, job, feed);
        add_geometry_equations(result,
                               {.feed_turn_deg = run.number("feed_turn_deg"),
                                .cylinder_radius_mm = run.number("cylinder_radius_mm"),
                                .ball_radius_mm = job.tool.radius});
        add_limit_equations(result, job,
                            {.r1 = run.number("r1"),
                             .r2 = run.number("r2"),
                             .feed_per_tooth_mm = feed,
                             .life_min = run.number("tool_life_min")});
        add_independence(result, reference_cuts(), job);
        run.write_result(result);
    });
}
