// SPDX-License-Identifier: GPL-3.0-or-later
// Effect of our choices on the calibrated totals of section 5 of Park & Maeng: the least
// feed per tooth, the concentration of force, the chip.
//
//   ball-end-milling-sensitivity OUTPUT_FOLDER
//
// Deterministic, under 30 s. Columns: README.md beside this.

#include "endmill/core/text.h"
#include "support/experiment.h"
#include "support/feed_plan_table.h"
#include "support/milling_jobs.h"

using namespace endmill;

namespace {

// A set of choices and its name.
struct Choice {
    std::string name;
    FeedPlanOptions options;
};

std::vector<Choice> choices(const std::vector<double>& least_feeds, double accuracy)
{
    const FeedPlanOptions paper{.accuracy = accuracy};
    std::vector<Choice> all{{"as calibrated", paper}};
    for (const double feed : least_feeds) {
        all.push_back({"least feed " + to_text(feed), paper});
        all.back().options.min_feed_per_tooth_mm = feed;
    }
    all.push_back({"peak torque", paper});
    all.back().options.peak = PeakRule::Torque;
    all.push_back({"peak direct", paper});
    all.back().options.peak = PeakRule::Direct;
    all.push_back({"exact chip", paper});
    all.back().options.chip = ChipModel::Exact;
    all.push_back({"exact force", paper});
    all.back().options.form = LimitForm::Exact;
    all.push_back({"corrected", corrected_feed_options()});
    return all;
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(
        argc, argv, "ball-end-milling/sensitivity", [](Experiment& run) {
            CsvTable result{{"row", "total_min", "force_share", "thrust_share",
                             "cap_share", "infeasible_share", "infeasible",
                             "peak_factor_5", "peak_factor_50", "peak_factor_95",
                             "peak_factor_greatest", "thrust_depth_mm",
                             "thrust_lambda_deg", "thrust_mu_deg", "thrust_deep_downhill",
                             "thrust_all_three_percent"}};
            const std::vector<SegmentCut> cuts = reference_cuts();
            const double noncut_min = run.number("noncut_min");
            for (const Choice& choice :
                 choices(run.numbers("least_feeds_mm"), run.number("accuracy")))
                for (const std::string& material : run.texts("materials")) {
                    const FeedPlan plan =
                        feed_plan(cuts, reference_job(material), choice.options);
                    add_named(result, material + ", " + choice.name,
                              sensitivity_cells(cuts, plan, noncut_min));
                }
            run.write_result(result);
        });
}
