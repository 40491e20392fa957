// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/viewed_passes.h"

#include <vector>

#include "endmill/core/text.h"
#include "endmill/files/path_file.h"
#include "endmill/files/result_csv.h"

namespace endmill {
namespace {

constexpr double above_stock_mm = 5;  // height of the tip on its return

}  // namespace

void write_passes_for_view(Experiment& run, const OneWayPasses& plan,
                           const MilledPath& milled, const std::string& part,
                           const FeedPlan* feeds)
{
    ToolPath path =
        milled_tool_path(milled, plan.radius, plan.stock_top + above_stock_mm);
    std::vector<SegmentCut> cuts = milled.cuts;
    std::size_t number = 0;
    for (PathPoint& point : path.points) {
        if (point.move != Move::Cut)
            continue;
        cuts[number].point = point.point;
        if (feeds)
            point.conditions.feed_mm_per_min = feeds->rows[number].table.feed_mm_per_min;
        ++number;
    }
    const std::string table = tool_path_csv(path);
    run.write("toolpath.csv", table);
    run.write("summary.json", "{\"name\": \"" + run.name() + "\", \"part\": \"" + part +
                                  "\", \"cutter\": \"ball:" + to_text(2 * plan.radius) +
                                  "\", \"toolpath_sha256\": \"" + content_sha256(table) +
                                  "\"}\n");
    if (feeds)
        run.write("engagement.csv", feed_csv(cuts, feeds->rows));
}

MilledPath moves_of_pass(const MilledPath& milled, int pass)
{
    MilledPath moves;
    for (std::size_t i = 0; i < milled.cuts.size(); ++i) {
        if (milled.cuts[i].pass != pass)
            continue;
        moves.cuts.push_back(milled.cuts[i]);
        moves.from.push_back(milled.from[i]);
        moves.to.push_back(milled.to[i]);
    }
    return moves;
}

}  // namespace endmill
