// SPDX-License-Identifier: GPL-3.0-or-later
// Conclusion 1 of Park & Maeng, the evaluation takes no longer than planning the path:
// times of both on the test surface, one thread.
//
//   ball-end-milling-planning-time OUTPUT_FOLDER
//
// About 20 s; measures time, so nothing else should run. Columns: README.md beside this.

#include "ball-end-milling/planning-time/one_way_plans.h"
#include "endmill/core/parallel.h"
#include "endmill/process/cutting_coefficients.h"
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

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(
        argc, argv, "ball-end-milling/planning-time", [](Experiment& run) {
            set_thread_count(1);
            CsvTable result{{"row", "segments", "plan_ms", "feed_ms", "feed_table_ms",
                             "feed_over_plan", "takes_no_longer"}};
            const std::vector<Surface> part{dataset_surface(run.text("surface"))};
            const MillingJob job = reference_job(run.text("material"));
            const OneWayRequest request{job.tool.radius, run.number("tolerance_mm"),
                                        run.number("scallop_mm"),
                                        run.number("return_z_mm")};
            const CoefficientTable table{ChipModel::Paper};
            const auto add = [&](const std::string& row, const auto& plan) {
                const ToolPath path = plan();
                const double plan_s = shortest_cpu_s(budget_s, plan);
                const auto feed_s = [&](const FeedPlanOptions& options) {
                    return shortest_cpu_s(
                        budget_s, [&] { return evaluate(path, part, job, options); });
                };
                const double direct_s = feed_s({});
                const auto segments =
                    static_cast<std::int64_t>(evaluate(path, part, job, {}));
                add_named(result, row,
                          {{"segments", segments},
                           {"plan_ms", ms * plan_s},
                           {"feed_ms", ms * direct_s},
                           {"feed_table_ms", ms * feed_s({.table = &table})},
                           {"feed_over_plan", direct_s / plan_s},
                           {"takes_no_longer", word(direct_s <= plan_s)}});
            };
            add("paper", [&] { return one_way_paper_path(part.front(), request); });
            add("verified", [&] { return one_way_verified_path(part.front(), request); });
            run.write_result(result);
        });
}
