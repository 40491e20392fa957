// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 10 of Park & Maeng: forces along one stroke at a constant and at the varied
// feed. The paper does not state which stroke is its A; ours is a pass of the path REF.
//
//   ball-end-milling-figure-10 OUTPUT_FOLDER
//
// Deterministic, under 10 s. Columns and verdicts: README.md beside this.

#include <algorithm>

#include "ball-end-milling/figure-10/stroke_comparison.h"
#include "support/along_path.h"
#include "support/milling_jobs.h"
#include "support/viewed_passes.h"

using namespace endmill;

namespace {

std::vector<std::string> stroke_columns()
{
    std::vector<std::string> columns{
        "row",          "minutes",      "removed_mm3_per_min",
        "force_x_n",    "force_y_n",    "thrust_n",
        "downhill_x_n", "downhill_y_n", "downhill_thrust_n",
        "x_variation",  "y_variation",  "thrust_variation"};
    for (const StrokeClaim& claim : stroke_claims())
        columns.push_back(claim.name);
    return columns;
}

void add_stroke(CsvTable& result, const std::string& name,
                const StrokeComparison& compared)
{
    add_named(result, name + ", constant",
              stroke_cells(compared.constant, compared.constant_variation));
    add_named(result, name + ", varied",
              stroke_cells(compared.varied, compared.varied_variation));
    add_named(result, name + ", claims", claim_cells(compared));
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "ball-end-milling/figure-10", [](Experiment& run) {
        CsvTable result{stroke_columns()};
        const int pass = static_cast<int>(run.number("pass"));
        const int steps = static_cast<int>(run.number("azimuths"));
        const double constant_mm = run.number("constant_feed_per_tooth_mm");
        const FeedPlanOptions options{.peak_factor = run.number("peak_factor"),
                                      .accuracy = run.number("accuracy")};
        const MilledPath milled = milled_path(reference_passes());
        const std::vector<SegmentCut>& cuts = milled.cuts;
        const int count_steps = static_cast<int>(run.number("azimuths_of_counts"));
        const MilledPath moves = moves_of_pass(milled, pass);
        const std::vector<SegmentCut>& stroke = moves.cuts;
        std::vector<StrokeComparison> all;
        for (const std::string& material : run.texts("materials")) {
            const MillingJob job = reference_job(material);
            const FeedPlan plan = feed_plan(stroke, job, options);
            const auto varied = milled_moves(stroke, plan, {});
            const auto constant = milled_moves(stroke, plan, constant_mm);
            const auto add = [&](const std::string& name, const std::string& file,
                                 const MillingJob& cutter) {
                const StrokeComparison& compared =
                    all.emplace_back(compared_strokes(constant, varied, cutter, steps));
                add_stroke(result, name, compared);
                add_named(result, name + ", passes of 40",
                          claim_counts(cuts, cutter, constant_mm, count_steps));
                const CsvTable turn = middle_turn(constant, varied, cutter, steps);
                run.write(file + "-forces.csv", compared.along.text());
                run.write(file + "-forces.svg",
                          along_figure("Forces along stroke A, " + name, compared.along));
                run.write(file + "-turn.csv", turn.text());
                run.write(file + "-turn.svg",
                          turn_figure("Forces in the middle of stroke A, " + name, turn));
            };
            add(material, material, job);
            add(material + ", right hand", material + "-right-hand", right_hand_job(job));
            add_named(result, material + ", passes of 40 by eq. (15)",
                      stated_claim_counts(cuts, job, constant_mm, options.peak_factor));
            write_along(run, material, "Stroke A, " + material, stroke, plan);
            if (material == run.text("material_in_3d"))
                write_passes_for_view(run, reference_passes(), moves,
                                      "datasets/surfaces/ball-end-test-surface.json",
                                      &plan);
        }
        NamedCells claims;
        for (const auto& [name, holds] : stroke_claims())
            claims.emplace_back(name, word(std::ranges::all_of(all, holds)));
        add_named(result, "claims in every set", claims);
        run.write_result(result);
    });
}
