// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 8 and 9 of Park & Maeng: geometry of the cut along the path over the test
// surface, with feed and spindle speed.
//
//   ball-end-milling-figure-8-9 OUTPUT_FOLDER
//
// Deterministic, under 1 s. Columns and verdicts: README.md beside this.

#include "support/along_path.h"
#include "support/milling_jobs.h"

using namespace endmill;

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "ball-end-milling/figure-8-9", [](Experiment& run) {
        CsvTable result{
            {"row", "least", "mean", "greatest", "jumps", "at_the_top", "longest_mm"}};
        const std::vector<SegmentCut> cuts = milled_path(reference_passes()).cuts;
        add_geometry(result, cuts);
        const double shallow_mm = run.number("shallow_mm");
        const FeedPlanOptions options{.accuracy = run.number("accuracy")};
        for (const std::string& material : run.texts("materials")) {
            const FeedPlan plan = feed_plan(cuts, reference_job(material), options);
            add_feeds(result, material, cuts, plan);
            const CapJumps jumps = cap_jumps(cuts, plan, shallow_mm);
            add_named(result, material + ", jumps to the cap",
                      {{"jumps", static_cast<std::int64_t>(jumps.count)},
                       {"at_the_top", static_cast<std::int64_t>(jumps.at_the_top)},
                       {"longest_mm", jumps.longest_mm}});
            write_along(run, material, "Feed along the path, " + material, cuts, plan);
        }
        run.write_result(result);
    });
}
