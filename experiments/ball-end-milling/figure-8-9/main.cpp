// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 8 and 9 of Park & Maeng: geometry of the cut along the path over the test
// surface, with feed and spindle speed.
//
//   ball-end-milling-figure-8-9 OUTPUT_FOLDER
//
// Deterministic, under 1 s. Columns and verdicts: README.md beside this.

#include "support/along_path.h"
#include "support/milling_jobs.h"
#include "support/path_statistics.h"
#include "support/viewed_passes.h"

using namespace endmill;

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "ball-end-milling/figure-8-9", [](Experiment& run) {
        CsvTable result{{"row", "least", "mean", "greatest", "largest_step_share",
                         "greatest_over_least", "jumps", "at_the_top", "longest_mm",
                         "passes_with_jump", "at_the_top_share", "shallow_passes_share",
                         "above_cap", "rank_correlation"}};
        const MilledPath milled = milled_path(reference_passes());
        const std::vector<SegmentCut>& cuts = milled.cuts;
        add_geometry(result, cuts);
        const double shallow_mm = run.number("shallow_mm");
        const FeedPlanOptions options{.accuracy = run.number("accuracy")};
        std::vector<std::vector<double>> feeds;
        for (const std::string& material : run.texts("materials")) {
            const MillingJob job = reference_job(material);
            const FeedPlan plan = feed_plan(cuts, job, options);
            add_feeds(result, material, cuts, plan);
            add_named(result, material + ", jumps to the cap",
                      jump_cells(cap_jumps(cuts, plan, shallow_mm,
                                           *job.material.max_feed_per_tooth_mm)));
            write_along(run, material, "Feed along the path, " + material, cuts, plan);
            if (material == run.text("material_in_3d"))
                write_passes_for_view(run, reference_passes(), milled,
                                      "datasets/surfaces/ball-end-test-surface.json",
                                      &plan);
            feeds.push_back(table_feeds(plan));
        }
        add_named(result, "feed of both materials",
                  {{"rank_correlation", rank_correlation(feeds.at(0), feeds.at(1))}});
        run.write_result(result);
    });
}
