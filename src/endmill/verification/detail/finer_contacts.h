// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "endmill/cutter/cutter.h"
#include "endmill/cutter/tool.h"
#include "endmill/path/tool_path.h"
#include "endmill/stock/height_stock.h"
#include "endmill/stock/removal.h"
#include "endmill/verification/detail/tool_runs.h"
#include "endmill/verification/verification_result.h"

namespace endmill {

/// Input of the search for contacts with the stock.
struct FinerContacts {
    const ToolPath& path;  ///< tips along +z
    const Cutter& cutter;
    std::span<const ToolCylinder> body;  ///< cylinders of shank and holder
    double most_bytes;  ///< memory for the finer cells; at least a few MB
    std::span<const ToolRun> later = {};  ///< runs of other tools that follow
};

/// Searches for contacts with the stock between the centres of the cells.
///
/// A removal detects a contact only at the centres of cells. This function simulates the
/// path again on cells that are three or nine times finer and include the old centres. It
/// covers the part of the block where a contact is possible: where a rapid passes below
/// the top of the block (except straight up from a place where the cutter has been), and
/// where a cylinder that reaches out of the cutter passes below it. If `coarse` has a
/// contact, the verdict is settled and nothing is simulated again.
/// \param coarse result of `remove_along` on `block` with the cells of `grid`.
StockContacts finer_contacts(const Removal& coarse, const Block& block,
                             const StockGrid& grid, const FinerContacts& task);

/// Returns the contacts of a removal from a stock that is known only at the centres of
/// its cells, with the width of the contacts that may have been missed.
/// \param top height of the highest material before the path, mm.
StockContacts contacts_of(const Removal& removal, const StockGrid& grid, double top,
                          const FinerContacts& task);

}  // namespace endmill
