// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "endmill/offset/detail/contact_strip.h"
#include "endmill/offset/detail/sheet_sides.h"

namespace endmill {

/// Adds the strips over creases, and what closes the corners at which they meet.
/// \param sides with the vertices of smooth joints made one.
/// \return for each side with a mate the chain over its first point, from its own vertex
/// to the mate's.
std::vector<ContactChain> add_crease_strips(std::span<const SheetSide> sides,
                                            OffsetDraft& draft);

/// Adds the strips along the border and around its corners.
/// \param seams what add_crease_strips returned.
void add_border_strips(std::span<const SheetSide> sides,
                       std::span<const ContactChain> seams, OffsetDraft& draft);

}  // namespace endmill
