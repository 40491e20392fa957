// SPDX-License-Identifier: GPL-3.0-or-later
// Conclusion 5 of Park & Maeng, "less danger of breaking the tip, less wear at the outer
// edge": force near the top of the stock and used tool life, at the constant and at the
// varied feed.
//
//   ball-end-milling-conclusion-5 OUTPUT_FOLDER
//
// Deterministic, under 20 s. Columns and verdicts: README.md beside this.

#include <algorithm>

#include "endmill/process/tool_life.h"
#include "support/experiment.h"
#include "support/milling_jobs.h"
#include "support/stroke_comparison.h"

using namespace endmill;

namespace {

// Largest force over the moves with a depth below `depth_mm`.
double largest_force(const std::vector<MilledMove>& moves,
                     const std::vector<double>& forces, double depth_mm)
{
    double largest = 0;
    for (std::size_t i = 0; i < moves.size(); ++i)
        if (moves[i].cut.depth_mm < depth_mm)
            largest = std::max(largest, forces[i]);
    return largest;
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(
        argc, argv, "ball-end-milling/conclusion-5", [](Experiment& run) {
            CsvTable result{{"row", "shallow_force_n", "force_n", "used_life",
                             "shallow_force_falls", "used_life_falls"}};
            const std::vector<SegmentCut> cuts = reference_cuts();
            const auto materials = run.texts("materials");
            const auto feeds = run.numbers("constant_feeds_mm_per_min");
            const auto speeds = run.numbers("constant_speeds_rpm");
            const double depth = run.number("shallow_radii") * reference_passes().radius;
            const double life = run.number("tool_life_min");
            const FeedPlanOptions options{.accuracy = run.number("accuracy")};
            bool force_falls = true;
            bool wear_falls = true;
            const auto add_job = [&](std::size_t i, const std::string& name,
                                     const MillingJob& job) {
                const auto add = [&](const std::string& row, const auto& moves) {
                    const auto forces = peak_cutting_forces(moves, job);
                    const double shallow = largest_force(moves, forces, depth);
                    const double used = used_life(moves, job, life);
                    add_named(result, name + ", " + row,
                              {{"shallow_force_n", shallow},
                               {"force_n", std::ranges::max(forces)},
                               {"used_life", used}});
                    return std::pair{shallow, used};
                };
                const auto constant =
                    add("constant",
                        constant_moves(cuts, job.tool.flutes, feeds.at(i), speeds.at(i)));
                const auto varied =
                    add("varied", milled_moves(cuts, feed_plan(cuts, job, options), {}));
                force_falls &= varied.first < constant.first;
                wear_falls &= varied.second < constant.second;
                add_named(result, name + ", claims",
                          {{"shallow_force_falls", word(varied.first < constant.first)},
                           {"used_life_falls", word(varied.second < constant.second)}});
            };
            for (std::size_t i = 0; i < materials.size(); ++i) {
                const MillingJob job = reference_job(materials[i]);
                add_job(i, materials[i], job);
                add_job(i, materials[i] + ", right hand", right_hand_job(job));
            }
            add_named(result, "claims in every set",
                      {{"shallow_force_falls", word(force_falls)},
                       {"used_life_falls", word(wear_falls)}});
            run.write_result(result);
        });
}
