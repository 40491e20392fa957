// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "endmill/deviation/part_charts.h"
#include "endmill/stock/detail/tool_pieces.h"
#include "endmill/verification/verification_result.h"

namespace endmill {

/// Finds contacts of shank and holder with the part while the axis turns.
///
/// The part is divided into cells. A cell is free if no piece comes nearer to its middle
/// than its reach; otherwise it is divided, down to a size far below `part_contact_slack`.
/// A contact is certain where the middle of a cell is deeper inside than that.
/// Source: docs/methods/five-axis-removal.md, section 6.
/// \param bodies   motions of shank and holder; their region holds the part.
/// \param pitch    mm, size of the first cells.
/// \param most_cells limit of the cells at work; beyond it the bound is not refined.
PartCollisions turning_contacts(const PartCharts& charts, const ToolPieces& bodies,
                                double pitch, std::size_t most_cells);

}  // namespace endmill
