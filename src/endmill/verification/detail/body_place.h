// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/core/vec.h"
#include "endmill/stock/detail/swept_move.h"
#include "endmill/stock/detail/tile_cut.h"

namespace endmill {

/// Depth of a place in a cylinder, open above, during a move.
struct BodyPlace {
    /// mm; the shortest way out, down or sideways, at the position where it is longest.
    /// It is negative outside, and the distance is then at most its amount.
    double depth;
    /// Supergradient of the depth: the depth at any other place is at most `depth` plus
    /// the scalar product of this vector and the way there.
    Vec3 rise;
};

/// Returns the depth of a place in the cylinder, maximised over the positions u of the
/// axis along the move. At each u the depth is the smaller of two lengths: the height of
/// the place over the cylinder's lower end and its distance from the cylinder's rim. Both
/// are concave in u and the place together. So the maximum is concave in the place, and
/// it changes by no more than the place moves.
/// Source: paper/notes/body-contacts.md, eq. (a). Accurate to 1e-12 of the coordinates.
BodyPlace place_in_body(const BodyCylinder& body, const SweptMove& move,
                        const Vec3& place);

}  // namespace endmill
