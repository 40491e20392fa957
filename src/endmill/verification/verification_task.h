// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

#include "endmill/cutter/tool.h"
#include "endmill/deviation/deviation.h"
#include "endmill/path/tool_path.h"
#include "endmill/stock/removal.h"
#include "endmill/stock/stock_history.h"
#include "endmill/surface/part.h"

/// \file
/// The input of `verify_path`: path, tools, stock, and the part to compare with.

namespace endmill {

/// The part with which `verify_path` compares the stock, and how.
struct JudgedPart {
    const Part* part;             ///< not null; must outlive this object
    DeviationLimits limits = {};  ///< of the verdict
    int max_refine = 8;           ///< largest number of halvings of a cell, 0 to 20
    /// If set, remaining stock is judged only where it returns true, see DeviationOptions.
    std::function<bool(const PartRay& ray)> is_accessible = {};
    /// Triangles of a mesh, ascending, whose remaining stock is not judged. Gouges are.
    std::vector<std::size_t> skipped_facets = {};
    /// If set, it is called with the finished share of the measurement, 0 to 1.
    std::function<void(double share)> progress = {};
};

/// How material is removed.
enum class RemovalEngine {
    ThreeAxis,  ///< heights over a grid; the axis is +z
    FiveAxis,   ///< dexels in three directions; the axis may turn
};

/// The input of `verify_path`. It refers to the part, the path and a kept stock, which
/// must outlive it.
struct VerificationTask {
    const ToolPath* path;                 ///< not null; ThreeAxis: tips along +z
    Cutter cutter;                        ///< the shape that cuts
    std::vector<ToolCylinder> body = {};  ///< cylinders of shank and holder
    /// mm, from the tip; above it the cutter does not cut, and its cylinder up to the first
    /// cylinder of the body must not touch the stock. Three axes take an endless cutter.
    double cutting_length = std::numeric_limits<double>::infinity();
    /// The part that the path machines; nothing: only the removal is simulated.
    std::optional<JudgedPart> judged = {};
    /// The material before the path: a block, or a stock that was kept (not null), such
    /// as the result of an earlier run or a mesh. Three axes take no dexels. Five axes take
    /// all; heights become dexels.
    std::variant<Block, const KeptStock*, const KeptDexels*> stock;
    /// mm; cell size of a block and distance of the first rays. Dexels that were kept have
    /// their own.
    double resolution = 0.1;
    double max_memory_gib = 8;  ///< limit of the memory, GiB
    /// Memory for output made from the remaining stock, per cell of its heights or ray.
    double extra_bytes_per_cell = 0;
    /// Changes to other tools, ascending by their first point. `cutter` and `body` are
    /// those of the tool before the first change.
    std::vector<ToolChange> changes = {};
    RemovalEngine engine = RemovalEngine::ThreeAxis;  ///< how material is removed
    /// If set, it is called with the finished share of the removal, 0 to 1; five axes only.
    std::function<void(double share)> progress = {};
};

/// Returns the charts of the task's part on which its places lie.
/// \pre the task has a part.
PartCharts judged_charts(const VerificationTask& task);

}  // namespace endmill
