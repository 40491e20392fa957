// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "endmill/offset/detail/contact_strip.h"
#include "endmill/offset/detail/grid_sides.h"

namespace endmill {

/// Adds the strips over creases, and closes the corners inside the part at which they
/// meet.
/// \param sides the sides of all grids; vertices on smooth joints are merged already.
/// \param draft the mesh.
/// \return for each side with a mate the chain over its first point, from its own vertex
///     to the mate's vertex.
std::vector<ContactChain> add_crease_strips(std::span<const GridSide> sides,
                                            OffsetDraft& draft);

/// Adds the strips along the border and around its corners.
/// \param sides the sides of all grids.
/// \param seams the result of add_crease_strips.
/// \param draft the mesh.
void add_border_strips(std::span<const GridSide> sides,
                       std::span<const ContactChain> seams, OffsetDraft& draft);

}  // namespace endmill
