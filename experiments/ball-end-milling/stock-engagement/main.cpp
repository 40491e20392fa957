// SPDX-License-Identifier: GPL-3.0-or-later
// The engagement of the path REF in the simulated stock and in the paper's model, and the
// true force peaks of the feed plans with either.
//
//   ball-end-milling-stock-engagement OUTPUT_FOLDER
//
// Deterministic, about 60 s on one core. Columns: README.md beside this.

#include "ball-end-milling/stock-engagement/tables.h"
#include "endmill/core/text.h"
#include "endmill/process/feed_plan.h"
#include "support/experiment.h"
#include "support/milling_jobs.h"

using namespace endmill;

int main(int argc, char** argv)
{
    return run_experiment(
        argc, argv, "ball-end-milling/stock-engagement", [](Experiment& run) {
            CsvTable result{
                {"row", "mean_i5", "mean_i7", "removed_mm3", "cut_min", "infeasible",
                 "idealised_peak_n", "idealised_over_percent", "simulated_peak_n",
                 "simulated_over_percent", "right_hand_idealised_peak_n",
                 "right_hand_idealised_over_percent", "right_hand_simulated_peak_n",
                 "right_hand_simulated_over_percent"}};
            const OneWayPasses plan = reference_passes();
            const MilledPath milled = milled_path(plan);
            const SimulatedCuts simulated =
                simulated_cuts(plan, milled, run.number("pitch_mm"));
            add_engagements(result, milled.cuts, simulated, plan.radius);
            const FeedPlanOptions paper{.accuracy = run.number("accuracy")};
            FeedPlanOptions direct = paper;
            direct.peak = PeakRule::Direct;
            for (const std::string& material : run.texts("materials")) {
                const PeakForceRun judged{milled.cuts, simulated,
                                          reference_job(material)};
                CsvTable along = judged.along_table();
                const auto add = [&](const std::string& name, const FeedPlan& feeds) {
                    judged.add(result, along, material + ", " + name, feeds);
                };
                add("idealised, R_m = 1.8", feed_plan(milled.cuts, judged.job, paper));
                add("idealised, direct", feed_plan(milled.cuts, judged.job, direct));
                add("simulated, R_m = 1.8",
                    simulated_plan(milled.cuts, simulated, judged.job, paper));
                add("simulated, direct",
                    simulated_plan(milled.cuts, simulated, judged.job, direct));
                const MillingJob right_hand = right_hand_job(judged.job);
                add("idealised, direct, right hand",
                    feed_plan(milled.cuts, right_hand, direct));
                add("simulated, direct, right hand",
                    simulated_plan(milled.cuts, simulated, right_hand, direct));
                run.write(material + "-peaks.csv", along.text());
            }
            run.write_result(result);
        });
}
