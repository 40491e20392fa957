// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <deque>
#include <limits>
#include <span>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/cutter/tool.h"
#include "endmill/path/tool_path.h"
#include "endmill/stock/removal.h"

namespace endmill {

/// The moves of a path between two changes of the tool.
struct ToolRun {
    const ToolPath& path;  ///< the moves; its first point is where the first one begins
    const Cutter& cutter;
    std::span<const ToolCylinder> body;  ///< cylinders of shank and holder
    std::size_t offset = 0;  ///< number of the first point of `path` in the whole path
    /// mm, from the tip; above it the cutter does not cut. Five axes only.
    double cutting_length = std::numeric_limits<double>::infinity();
};

/// A path, its first tool and the changes to others.
struct ChangingTool {
    const ToolPath& path;                 ///< whole
    const Cutter& cutter;                 ///< of the first tool
    std::span<const ToolCylinder> body;   ///< of the first tool
    std::span<const ToolChange> changes;  ///< ascending by their first point
    /// mm, of the first tool. Five axes only.
    double cutting_length = std::numeric_limits<double>::infinity();
};

/// The runs of a path, one more than changes of the tool. A run after a change begins at
/// the last point of the run before, where its tool cuts nothing.
class ToolRuns {
public:
    /// `task` must outlive this object.
    /// \throws DomainError unless the changes ascend and lie within the path, after its
    ///         first point.
    explicit ToolRuns(const ChangingTool& task);
    ToolRuns(const ToolRuns&) = delete;             ///< the runs refer to it
    ToolRuns& operator=(const ToolRuns&) = delete;  ///< the runs refer to it

    std::span<const ToolRun> list() const { return runs_; }  ///< in the order of cutting

private:
    std::deque<ToolPath> parts_;
    std::vector<ToolRun> runs_;
};

/// Removes the material along all runs, as `remove_along` does along one. Points are
/// numbered through the whole path.
Removal remove_along(HeightStock& stock, std::span<const ToolRun> runs);

}  // namespace endmill
