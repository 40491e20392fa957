// SPDX-License-Identifier: GPL-3.0-or-later
// Conclusions 4 and 5 of Park & Maeng: concentration of force, use of the machine, force
// near the top of the stock and used tool life, at the constant and at the varied feed.
//
//   ball-end-milling-conclusion-5 OUTPUT_FOLDER
//
// Deterministic, under 20 s. Columns and verdicts: README.md beside this.

#include <cmath>

#include "ball-end-milling/conclusion-5/measures.h"
#include "support/experiment.h"
#include "support/milling_jobs.h"

using namespace endmill;

int main(int argc, char** argv)
{
    return run_experiment(
        argc, argv, "ball-end-milling/conclusion-5", [](Experiment& run) {
            CsvTable result{measure_columns()};
            const std::vector<SegmentCut> cuts = reference_cuts();
            const auto materials = run.texts("materials");
            const auto feeds = run.numbers("constant_feeds_mm_per_min");
            const auto speeds = run.numbers("constant_speeds_rpm");
            const MeasureRules rules{
                run.number("shallow_radii") * reference_passes().radius,
                run.number("tool_life_min"), run.number("peak_factor")};
            const FeedPlanOptions options{.peak_factor = rules.peak_factor,
                                          .accuracy = run.number("accuracy")};
            std::vector<bool> in_every_set(feed_claims().size(), true);
            const auto add_job = [&](std::size_t i, const std::string& name,
                                     const MillingJob& job) {
                const FeedMeasures constant = feed_measures(
                    constant_moves(cuts, job.tool.flutes, feeds.at(i), speeds.at(i)), job,
                    rules);
                const FeedMeasures varied = feed_measures(
                    milled_moves(cuts, feed_plan(cuts, job, options), {}), job, rules);
                add_named(result, name + ", constant", measure_cells(constant));
                add_named(result, name + ", varied", measure_cells(varied));
                // At a constant table feed the used life grows with n^(1/alpha).
                NamedCells claims{
                    {"equal_life_rpm",
                     speeds[i] * std::pow(varied.used_life / constant.used_life,
                                          job.material.alpha)}};
                for (std::size_t k = 0; k < in_every_set.size(); ++k) {
                    const bool holds = feed_claims()[k].holds(constant, varied);
                    in_every_set[k] = in_every_set[k] && holds;
                    claims.emplace_back(feed_claims()[k].name, word(holds));
                }
                add_named(result, name + ", claims", claims);
            };
            for (std::size_t i = 0; i < materials.size(); ++i) {
                const MillingJob job = reference_job(materials[i]);
                add_job(i, materials[i], job);
                add_job(i, materials[i] + ", right hand", right_hand_job(job));
            }
            NamedCells claims;
            for (std::size_t k = 0; k < in_every_set.size(); ++k)
                claims.emplace_back(feed_claims()[k].name, word(in_every_set[k]));
            add_named(result, "claims in every set", claims);
            run.write_result(result);
        });
}
