// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/core/vec.h"
#include "endmill/stock/detail/swept_move.h"
#include "endmill/stock/detail/tile_cut.h"

namespace endmill {

/// How deep a place is in a cylinder, open above, on a move.
struct BodyPlace {
    /// mm: the least way out, down or sideways, where the place is deepest; negative
    /// outside, and then no further away than this.
    double depth;
    /// Nowhere is the depth more than here and this times the way there: it is concave.
    Vec3 rise;
};

/// Of the positions u of the axis along the move: the greatest of the lesser of the
/// place's height over the cylinder's lower end and its distance from the cylinder's rim.
/// Both are concave in u and the place together, so their depth is in the place, which
/// changes it by no more than it is moved. Derived in paper/notes/body-contacts.md.
/// Accurate to 1e-12 of the coordinates.
BodyPlace place_in_body(const BodyCylinder& body, const SweptMove& move,
                        const Vec3& place);

}  // namespace endmill
