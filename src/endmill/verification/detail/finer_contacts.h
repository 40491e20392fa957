// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "endmill/cutter/cutter.h"
#include "endmill/cutter/tool.h"
#include "endmill/path/tool_path.h"
#include "endmill/stock/height_stock.h"
#include "endmill/stock/removal.h"

namespace endmill {

/// What must not touch the stock and does, and what may have been missed.
struct StockContacts {
    MoveCount rapid_cuts = {};
    MoveCount collisions = {};
    /// mm; where it is missed, a cut or contact is narrower, seen from above: no circle of
    /// this diameter fits in. 0 if no move could touch anything but where it was cut before.
    double width_mm = 0;
};

/// How the contacts of a removal are looked at again.
struct FinerContacts {
    const ToolPath& path;  ///< tips along +z
    const Cutter& cutter;
    std::span<const ToolCylinder> body;  ///< shank and holder
    double most_bytes;                   ///< for the finer cells, of a few MB at least
};

/// Contacts are seen at the centres of cells. So the part of a block over which rapids pass
/// below its top, other than straight up from where the cutter has been, and shank or
/// holder, where they reach out of the cutter, is cut once more in cells three or nine times as
/// fine, which keep the centres. Not so where `coarse` saw a contact, which settles the
/// verdict.
/// \param coarse what `remove_along` found of `block` in the cells of `grid`.
StockContacts finer_contacts(const Removal& coarse, const Block& block,
                             const StockGrid& grid, const FinerContacts& task);

/// The contacts of a removal from a stock that is known at the centres of its cells only.
StockContacts contacts_of(const Removal& removal, const StockGrid& grid, double top,
                          const FinerContacts& task);

}  // namespace endmill
