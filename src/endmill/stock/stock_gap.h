// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "endmill/cutter/cutter.h"
#include "endmill/path/tool_path.h"
#include "endmill/stock/height_stock.h"

namespace endmill {

/// How far a ball-end mill, its shank included, stays away from a block on the moves to
/// `points`, in mm: 0 where it meets the block on one of them; infinity without moves.
/// \param points of the path after its first. \pre The axis is +z; not checked.
/// \throws DomainError unless the cutter is a ball and the points are as said.
/// Error below 1e-6 of the longest move; none where it meets the block by more than that.
double stock_gap(const ToolPath& path, std::span<const std::size_t> points,
                 const Cutter& cutter, const Block& block);

}  // namespace endmill
