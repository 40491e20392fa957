// SPDX-License-Identifier: GPL-3.0-or-later
// Plans feed and spindle speed for each move of a path from the cutting forces.

#include <exception>
#include <iostream>

#include "endmill/files.h"
#include "endmill/planning.h"
#include "endmill/process.h"

int main()
try {
    using namespace endmill;
    const auto part = read_surface("datasets/surfaces/wavy.json");
    const BallCutter ball{/*radius=*/5};
    const ToolPath path =
        plan_iso_parametric(part.surfaces, ball, {.chord_tolerance = 0.5}).path;
    const SegmentCuts cuts = segment_cuts(path, {.radius = 5, .stock_top = 6});

    const MillingTool tool{.radius = 5, .flutes = 2, .limits = {.cutting_force_n = 1200}};
    const MillingJob job{read_material("datasets/materials/steel.json"), tool};
    const FeedPlan plan = feed_plan(cuts.cuts, job, FeedPlanOptions{});

    std::cout << plan.rows.size() << " moves, " << plan.totals.cut_min
              << " min of cutting\n";
} catch (const std::exception& error) {
    std::cerr << "feed: " << error.what() << '\n';
    return 2;
}
