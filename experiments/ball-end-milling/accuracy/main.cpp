// SPDX-License-Identifier: GPL-3.0-or-later
// Accuracy of the linearised force expressions of Park & Maeng: the peaks that eq. (15)
// and (16) state, R_m times the mean, against the peaks of the turning flutes.
//
//   ball-end-milling-accuracy OUTPUT_FOLDER
//
// Deterministic, under 30 s. Columns and verdicts: README.md beside this.

#include "ball-end-milling/accuracy/stated_peaks.h"
#include "support/experiment.h"
#include "support/milling_jobs.h"

using namespace endmill;

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "ball-end-milling/accuracy", [](Experiment& run) {
        CsvTable result{{"row", "within_percent", "ratio_5", "ratio_50", "ratio_95",
                         "ratio_greatest", "thrust_downhill", "thrust_uphill",
                         "thrust_understated_downhill", "over_percent"}};
        CsvTable along{{"row", "share_percent", "ratio", "set"}};
        const std::vector<SegmentCut> cuts = milled_path(reference_passes()).cuts;
        const double tolerance = run.number("tolerance");
        const FeedPlanOptions options{.peak_factor = run.number("peak_factor"),
                                      .accuracy = run.number("accuracy")};
        Extremes constant_rule;
        Extremes torque_rule;
        const auto add = [&](const std::string& name, const MillingJob& job,
                             bool is_drawn) {
            const auto moves = milled_moves(cuts, feed_plan(cuts, job, options), {});
            const auto peaks = peak_loads(moves, job);
            const auto add_rule = [&](const std::string& rule, const PeakRatios& ratios,
                                      double over, Extremes& extremes) {
                add_named(
                    result, name + ", R_m " + rule,
                    joined(joined(ratios.force_cells(tolerance), ratios.thrust_cells()),
                           {{"over_percent", over}}));
                extremes.add(ratios, tolerance, over);
            };
            const PeakRatios constant{moves, peaks,
                                      stated_loads(moves, job, options.peak_factor)};
            if (is_drawn)
                add_quantiles(along, name + ", constant", constant);
            add_rule("constant", constant, over_percent(moves, peaks, job),
                     constant_rule);
            const PeakRatios torque{moves, peaks, torque_stated_loads(moves, job)};
            if (is_drawn)
                add_quantiles(along, name + ", torque", torque);
            FeedPlanOptions by_torque = options;
            by_torque.peak = PeakRule::Torque;
            const auto torque_moves =
                milled_moves(cuts, feed_plan(cuts, job, by_torque), {});
            add_rule("by torque", torque,
                     over_percent(torque_moves, peak_loads(torque_moves, job), job),
                     torque_rule);
        };
        for (const std::string& material : run.texts("materials")) {
            const MillingJob job = reference_job(material);
            const bool is_drawn = material == run.text("drawn_material");
            add(material, job, is_drawn);
            add(material + ", right hand", right_hand_job(job), is_drawn);
        }
        add_named(result, "every set, R_m constant", constant_rule.cells());
        add_named(result, "every set, R_m by torque", torque_rule.cells());
        run.write_result(result);
        run.write("ratios.csv", along.text());
    });
}
