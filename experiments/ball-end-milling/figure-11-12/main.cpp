// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 11 and 12 of Park & Maeng on a saddle of this project, because theirs is not
// printed: surface and path, geometry, feed and spindle speed for steel.
//
//   ball-end-milling-figure-11-12 OUTPUT_FOLDER
//
// Deterministic, under 2 s. Columns and verdicts: README.md beside this.

#include "ball-end-milling/figure-11-12/comparison.h"
#include "endmill/figures/tool_path_svg.h"
#include "endmill/files/mesh_file.h"
#include "endmill/surface/sampling.h"
#include "support/along_path.h"
#include "support/milling_jobs.h"
#include "support/passes_table.h"
#include "support/viewed_passes.h"

using namespace endmill;

namespace {

constexpr double above_stock_mm = 5;  // height of the tip on its return

OneWayPasses saddle_passes(double over_the_top_mm)
{
    OneWayPasses plan = reference_passes();
    plan.surface = bicycle_saddle;
    plan.extent = {{-90, 90}, {-20, 20}};
    plan.stock_top =
        surface_facts(plan.surface, plan.extent, 0, 240).greatest_z_mm + over_the_top_mm;
    return plan;
}

void write_figures(Experiment& run, const OneWayPasses& plan, const MilledPath& milled,
                   const FeedPlan& feeds)
{
    const SurfaceDrawing surface{.figure = {.title = "A saddle of our own"},
                                 .spaces_per_patch = 2};
    const Surface saddle = gridded(plan.surface, plan.extent, 24, 12);
    run.write("saddle.svg", surface_svg(saddle, surface));
    const ToolPath path =
        milled_tool_path(milled, plan.radius, plan.stock_top + above_stock_mm);
    run.write("path.svg", tool_path_svg(path, {.title = "Cutter path over it, tips"}));
    const TriangleMesh part =
        sampled({&saddle, 1}, std::vector{1.0}, run.number("chord_tolerance_mm")).mesh;
    run.write("saddle.stl", mesh_text(part, MeshFormat::Stl));
    write_passes_for_view(run, plan, milled, "saddle.stl", &feeds);
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(
        argc, argv, "ball-end-milling/figure-11-12", [](Experiment& run) {
            std::vector<std::string> columns{"row",
                                             "least_z_mm",
                                             "greatest_z_mm",
                                             "area_mm2",
                                             "steepest_deg",
                                             "least_radius_mm",
                                             "above_stock_percent",
                                             "passes",
                                             "segments",
                                             "cl_length_mm",
                                             "least",
                                             "mean",
                                             "greatest",
                                             "largest_step_share",
                                             "greatest_over_least",
                                             "jumps",
                                             "cut_min",
                                             "mean_feed_mm_per_min"};
            for (const std::string& column : comparison_columns())
                columns.push_back(column);
            CsvTable result{columns};
            const OneWayPasses plan = saddle_passes(run.number("least_depth_mm"));
            const MilledPath milled = milled_path(plan);
            const MillingJob job = reference_job(run.text("material"));
            const FeedPlanOptions options{.accuracy = run.number("accuracy")};
            const FeedPlan feeds = feed_plan(milled.cuts, job, options);
            add_named(result, "surface", surface_cells(plan));
            add_named(result, "path", path_cells(plan));
            add_geometry(result, milled.cuts);
            add_feeds(result, run.text("material"), milled.cuts, feeds);
            add_named(
                result, "cutting",
                {{"cut_min", feeds.totals.cut_min},
                 {"mean_feed_mm_per_min", feeds.totals.length_mm / feeds.totals.cut_min},
                 {"jumps", std::int64_t{cap_jumps(milled.cuts, feeds, plan.radius / 2,
                                                  *job.material.max_feed_per_tooth_mm)
                                            .count}}});
            const CsvTable quantiles =
                add_comparison(result, "saddle", plan, job, options);
            run.write_result(result);
            run.write("feeds.csv", quantiles.text());
            write_along(run, run.text("material"),
                        "Feed along the path, our saddle, steel", milled.cuts, feeds);
            write_figures(run, plan, milled, feeds);
        });
}
