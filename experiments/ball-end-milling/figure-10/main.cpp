// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 10 of Park & Maeng: forces along one stroke at a constant and at the varied
// feed. The paper does not state which stroke is its A; ours is a pass of the path REF.
//
//   ball-end-milling-figure-10 OUTPUT_FOLDER
//
// Deterministic, under 10 s. Columns and verdicts: README.md beside this.

#include "support/along_path.h"
#include "support/milling_jobs.h"
#include "support/stroke_comparison.h"

using namespace endmill;

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "ball-end-milling/figure-10", [](Experiment& run) {
        CsvTable result{{"row", "minutes", "removed_mm3_per_min", "force_x_n",
                         "force_y_n", "thrust_n", "downhill_x_n", "downhill_y_n",
                         "downhill_thrust_n", "faster_with_smaller_peaks",
                         "downhill_thrust_hardly_falls"}};
        const int pass = static_cast<int>(run.number("pass"));
        const int steps = static_cast<int>(run.number("azimuths"));
        const double constant_mm = run.number("constant_feed_per_tooth_mm");
        const FeedPlanOptions options{.accuracy = run.number("accuracy")};
        const std::vector<SegmentCut> cuts = milled_path(reference_passes()).cuts;
        const int count_steps = static_cast<int>(run.number("azimuths_of_counts"));
        std::vector<SegmentCut> stroke = cuts;
        std::erase_if(stroke, [&](const SegmentCut& cut) { return cut.pass != pass; });
        bool is_faster = true;
        bool thrust_hardly_falls = true;
        for (const std::string& material : run.texts("materials")) {
            const MillingJob job = reference_job(material);
            const FeedPlan plan = feed_plan(stroke, job, options);
            const auto varied = milled_moves(stroke, plan, {});
            const auto constant = milled_moves(stroke, plan, constant_mm);
            const auto add = [&](const std::string& name, const std::string& file,
                                 const MillingJob& cutter) {
                const StrokeComparison compared =
                    compared_strokes(constant, varied, cutter, steps);
                is_faster &= is_faster_with_smaller_peaks(compared);
                thrust_hardly_falls &= downhill_thrust_hardly_falls(compared);
                add_named(result, name + ", constant", stroke_cells(compared.constant));
                add_named(result, name + ", varied", stroke_cells(compared.varied));
                add_named(result, name + ", claims", claim_cells(compared));
                add_named(result, name + ", passes of 40",
                          claim_counts(cuts, cutter, constant_mm, count_steps));
                run.write(file + "-forces.csv", compared.along.text());
                run.write(file + "-turn.csv",
                          middle_turn(constant, varied, cutter, steps).text());
            };
            add(material, material, job);
            add(material + ", right hand", material + "-right-hand", right_hand_job(job));
            write_along(run, material, "Stroke A, " + material, stroke, plan);
        }
        add_named(result, "claims in every set",
                  {{"faster_with_smaller_peaks", word(is_faster)},
                   {"downhill_thrust_hardly_falls", word(thrust_hardly_falls)}});
        run.write_result(result);
    });
}
