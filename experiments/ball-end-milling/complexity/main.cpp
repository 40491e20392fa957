// SPDX-License-Identifier: GPL-3.0-or-later
// Conclusion 3 of Park & Maeng, "the more complex the surface, the larger the saving": the
// saving over the test surface with its heights scaled, against the constant feed of the
// paper and against a constant feed that is safe for the surface itself.
//
//   ball-end-milling-complexity OUTPUT_FOLDER
//
// Deterministic, under 10 s. Columns and verdicts: README.md beside this.

#include <algorithm>

#include "endmill/core/text.h"
#include "endmill/process/fed_path.h"
#include "support/experiment.h"
#include "support/milling_jobs.h"
#include "support/named_cells.h"
#include "support/path_statistics.h"
#include "support/stated_loads.h"

using namespace endmill;

namespace {

// The passes over the test surface with its heights times `factor`.
OneWayPasses scaled_passes(double factor)
{
    OneWayPasses passes = reference_passes();
    passes.surface = [factor](double x, double y) {
        HeightJet jet = ball_end_test_surface(x, y);
        for (double* part : {&jet.z, &jet.zx, &jet.zy, &jet.zxx, &jet.zxy, &jet.zyy})
            *part *= factor;
        return jet;
    };
    return passes;
}

// Savings on one surface, in percent of the cutting time.
struct Savings {
    double complexity;  // variation of the force by eq. (15) at a constant feed per tooth
    double by_paper;    // against the constant feed of the paper
    double by_own;      // against the constant feed that is safe for the surface
};

// The safe constant feed is the least planned feed but for `unsafe_share` of the length.
Savings savings(const std::vector<SegmentCut>& cuts, const MillingJob& job,
                double paper_feed, double constant_mm, double unsafe_share)
{
    const FeedPlan plan = feed_plan(cuts, job, {});
    const std::vector<double> lengths = lengths_of(cuts);
    const auto moves = milled_moves(cuts, plan, constant_mm);
    const double own_feed = weighted_quantile(table_feeds(plan), lengths, unsafe_share);
    const auto saving = [&](double feed) {
        return saving_percent(plan.totals.cut_min, plan.totals.length_mm / feed);
    };
    return {variation(cutting_forces(stated_loads(moves, job, 1)), lengths),
            saving(paper_feed), saving(own_feed)};
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "ball-end-milling/complexity", [](Experiment& run) {
        CsvTable result{{"row", "height_factor", "complexity", "saving_percent",
                         "own_saving_percent", "correlation", "own_correlation"}};
        const auto factors = run.numbers("height_factors");
        const auto materials = run.texts("materials");
        const auto feeds = run.numbers("constant_feeds_mm_per_min");
        double least = 1;
        double own_least = 1;
        for (std::size_t i = 0; i < materials.size(); ++i) {
            std::vector<double> complexity;
            std::vector<double> by_paper;
            std::vector<double> by_own;
            for (const double factor : factors) {
                const Savings found = savings(milled_path(scaled_passes(factor)).cuts,
                                              reference_job(materials[i]), feeds.at(i),
                                              run.number("constant_feed_per_tooth_mm"),
                                              run.number("unsafe_share"));
                add_named(result, materials[i] + ", heights times " + to_text(factor),
                          {{"height_factor", factor},
                           {"complexity", found.complexity},
                           {"saving_percent", found.by_paper},
                           {"own_saving_percent", found.by_own}});
                complexity.push_back(found.complexity);
                by_paper.push_back(found.by_paper);
                by_own.push_back(found.by_own);
            }
            const double one = rank_correlation(by_paper, complexity);
            const double own = rank_correlation(by_own, complexity);
            add_named(result, materials[i],
                      {{"correlation", one}, {"own_correlation", own}});
            least = std::min(least, one);
            own_least = std::min(own_least, own);
        }
        add_named(result, "least of both materials",
                  {{"correlation", least}, {"own_correlation", own_least}});
        run.write_result(result);
    });
}
