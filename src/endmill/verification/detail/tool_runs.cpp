// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/tool_runs.h"

#include <algorithm>
#include <utility>

#include "endmill/core/error.h"

namespace endmill {
namespace {

// The points from one before `first` to one before `end`. The first one is a rapid, since
// the cutter of this run removes nothing there.
ToolPath part_of(const ToolPath& path, std::size_t first, std::size_t end)
{
    const auto at = [&](std::size_t number) {
        return path.points.begin() + static_cast<std::ptrdiff_t>(number);
    };
    ToolPath part{{at(first - 1), at(end)}};
    part.points.front().move = Move::Rapid;
    return part;
}

void add(MoveCount& all, const MoveCount& more, std::size_t offset)
{
    all.count += more.count;
    if (!all.first && more.first)
        all.first = *more.first + offset;
    all.deepest = std::max(all.deepest, more.deepest);
}

// Appends the moves of a later run.
void append(Removal& all, const Removal& run, std::size_t offset)
{
    all.removed.insert(all.removed.end(), run.removed.begin() + 1, run.removed.end());
    all.deepest.insert(all.deepest.end(), run.deepest.begin() + 1, run.deepest.end());
    all.total += run.total;
    all.air_moves += run.air_moves;
    add(all.rapid_cuts, run.rapid_cuts, offset);
    add(all.collisions, run.collisions, offset);
    all.left = run.left;
}

}  // namespace

ToolRuns::ToolRuns(const ChangingTool& task)
{
    const auto& changes = task.changes;
    if (changes.empty()) {
        runs_.push_back({task.path, task.cutter, task.body, 0, task.cutting_length});
        return;
    }
    const std::size_t points = task.path.points.size();
    std::size_t last = 0;
    for (const ToolChange& change : changes) {
        require(last < change.first && change.first < points,
                "verify_path: need changes of the tool that ascend within the path");
        last = change.first;
    }
    parts_.push_back(ToolPath{
        {task.path.points.begin(),
         task.path.points.begin() + static_cast<std::ptrdiff_t>(changes.front().first)}});
    runs_.push_back({parts_.back(), task.cutter, task.body, 0, task.cutting_length});
    for (std::size_t k = 0; k < changes.size(); ++k) {
        const std::size_t end = k + 1 < changes.size() ? changes[k + 1].first : points;
        parts_.push_back(part_of(task.path, changes[k].first, end));
        runs_.push_back({parts_.back(), changes[k].cutter, changes[k].body,
                         changes[k].first - 1, changes[k].cutting_length});
    }
}

Removal remove_along(HeightStock& stock, std::span<const ToolRun> runs)
{
    Removal all;
    for (const ToolRun& run : runs) {
        Removal removal = remove_along(stock, run.path, run.cutter,
                                       {{run.body.begin(), run.body.end()}});
        if (run.offset == 0 && all.removed.empty())
            all = std::move(removal);
        else
            append(all, removal, run.offset);
    }
    return all;
}

}  // namespace endmill
