// SPDX-License-Identifier: GPL-3.0-or-later
// Conclusion 1 of Park & Maeng, the evaluation takes no longer than planning the path:
// times of both on the test surface, one thread.
//
//   ball-end-milling-planning-time OUTPUT_FOLDER
//
// About 20 s; measures time, so nothing else should run. Columns: README.md beside this.

#include <cmath>

#include "ball-end-milling/planning-time/one_way_plans.h"
#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/process/cutting_coefficients.h"
#include "endmill/process/detail/segment_load.h"
#include "endmill/process/detail/stroke_forces.h"
#include "endmill/process/segment_cuts.h"
#include "support/cpu_time.h"
#include "support/experiment.h"
#include "support/milling_jobs.h"
#include "support/named_cells.h"

using namespace endmill;

namespace {

constexpr double budget_s = 1;  // time of one measurement
constexpr double ms = 1e3;

// The work of `endmill feed` on a path and its part, without files.
std::size_t evaluate(const ToolPath& path, const std::vector<Surface>& part,
                     const MillingJob& job, const FeedPlanOptions& options)
{
    const SegmentCuts found =
        segment_cuts(path, {.radius = job.tool.radius,
                            .stock_top = reference_passes().stock_top,
                            .first_pass = PreviousPass::Edge,
                            .part = part});
    return feed_plan(found.cuts, job, options).rows.size();
}

// CPU time of `evaluate`, s.
double feed_cpu_s(const ToolPath& path, const std::vector<Surface>& part,
                  const MillingJob& job, const FeedPlanOptions& options)
{
    return shortest_cpu_s(budget_s, [&] { return evaluate(path, part, job, options); });
}

// Times of a turn of forces at `steps` azimuths and of the mean force, for moves along the
// path REF.
void add_turn(CsvTable& result, const MillingJob& job, int steps)
{
    constexpr std::size_t every = 40;       // moves
    constexpr double short_budget_s = 0.2;  // a turn takes a millisecond
    const std::vector<SegmentCut> all = milled_path(reference_passes()).cuts;
    std::vector<MilledMove> moves;
    for (std::size_t i = every / 2; i < all.size(); i += every)
        moves.push_back({all[i], /*feed_per_tooth_mm=*/0.1, /*spindle_rpm=*/1000});
    double sum = 0;
    const double turn_s = shortest_cpu_s(short_budget_s, [&] {
        for (const MilledMove& move : moves)
            sum += turn_forces(move, job, steps).front().x_n;
    });
    const double mean_s = shortest_cpu_s(short_budget_s, [&] {
        for (const MilledMove& move : moves) {
            const CuttingCoefficients coefficients = cutting_coefficients(
                ball_engagement(move.cut, job.tool.radius), ChipModel::Paper, 1e-6);
            sum += mean_force(coefficients, job.material, job.tool,
                              move.feed_per_tooth_mm, move.cut.milling)
                       .x_n;
        }
    });
    require(std::isfinite(sum), "planning-time: a force is not finite");
    const double count = static_cast<double>(moves.size());
    add_named(result, "forces over a turn",
              {{"turn_ms", ms * turn_s / count},
               {"mean_ms", ms * mean_s / count},
               {"turn_over_mean", turn_s / mean_s}});
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(
        argc, argv, "ball-end-milling/planning-time", [](Experiment& run) {
            set_thread_count(1);
            CsvTable result{{"row", "segments", "plan_ms", "feed_ms", "feed_table_ms",
                             "feed_over_plan", "takes_no_longer", "turn_ms", "mean_ms",
                             "turn_over_mean"}};
            const std::vector<Surface> part{dataset_surface(run.text("surface"))};
            const MillingJob job = reference_job(run.text("material"));
            const OneWayRequest request{job.tool.radius, run.number("tolerance_mm"),
                                        run.number("scallop_mm"),
                                        run.number("return_z_mm")};
            const CoefficientTable table{ChipModel::Paper};
            const auto add = [&](const std::string& row, const auto& plan) {
                const ToolPath path = plan();
                const double plan_s = shortest_cpu_s(budget_s, plan);
                const double direct_s = feed_cpu_s(path, part, job, {});
                const double table_s = feed_cpu_s(path, part, job, {.table = &table});
                const auto segments =
                    static_cast<std::int64_t>(evaluate(path, part, job, {}));
                add_named(result, row,
                          {{"segments", segments},
                           {"plan_ms", ms * plan_s},
                           {"feed_ms", ms * direct_s},
                           {"feed_table_ms", ms * table_s},
                           {"feed_over_plan", direct_s / plan_s},
                           {"takes_no_longer", word(direct_s <= plan_s)}});
            };
            add("paper", [&] { return one_way_paper_path(part.front(), request); });
            add("verified", [&] { return one_way_verified_path(part.front(), request); });
            add_turn(result, job, static_cast<int>(run.number("azimuths")));
            run.write_result(result);
        });
}
