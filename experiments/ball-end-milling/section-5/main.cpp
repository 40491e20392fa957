// SPDX-License-Identifier: GPL-3.0-or-later
// Times and savings in section 5 of Park & Maeng: relations between the printed times,
// and the calibrated plan of the path REF.
//
//   ball-end-milling-section-5 OUTPUT_FOLDER
//
// Deterministic, under 1 s. Columns and verdicts: README.md beside this.

#include "ball-end-milling/section-5/tables.h"
#include "support/experiment.h"
#include "support/feed_plan_table.h"
#include "support/milling_jobs.h"

using namespace endmill;

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "ball-end-milling/section-5", [](Experiment& run) {
        CsvTable result{time_columns()};
        const PrintedTimes printed{
            .materials = run.texts("materials"),
            .length_mm = run.number("printed_length_mm"),
            .feeds_mm_per_min = run.numbers("constant_feeds_mm_per_min"),
            .constant_feed_min = run.numbers("printed_constant_feed_min"),
            .variable_feed_min = run.numbers("printed_variable_feed_min"),
            .rounding_min = run.number("rounding_min")};
        const double noncut_min = run.number("noncut_min");
        const FeedPlanOptions options{.accuracy = run.number("accuracy")};
        add_accounts(result, printed, noncut_min);
        const OneWayPasses passes = reference_passes();
        const double travel =
            noncut_travel_mm(milled_path(passes), passes.radius,
                             run.number("return_z_mm"), run.number("overrun_mm"));
        add_named(result, "REF: travel but for cutting",
                  {{"length_mm", travel},
                   {"noncut_min", noncut_min},
                   {"mean_feed_mm_per_min", travel / noncut_min}});
        std::vector<FeedPlan> plans;
        for (std::size_t i = 0; i < printed.materials.size(); ++i) {
            const std::string& material = printed.materials[i];
            const MillingJob job = reference_job(material);
            const FeedPlan& plan =
                plans.emplace_back(feed_plan(reference_cuts(), job, options));
            const NamedCells times =
                time_cells(plan, {noncut_min, printed.feeds_mm_per_min[i]});
            add_named(result, "REF, " + material,
                      joined(joined(times, saving_cells(times)),
                             joined(limit_cells(plan), machine_cells(plan, job))));
        }
        add_named(result, "carbon steel",
                  {{"names", different_names(run.texts("printed_steel_names"))}});
        add_named(result, "claims", limit_claims(plans));
        run.write_result(result);
    });
}
