// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "endmill/surface/bezier_patch.h"

namespace endmill {

/// A bicubic patch by its corners, the partials there and the twists: Ferguson's form,
/// whose own patches have zero twists.
struct FergusonPatch {
    /// What the patch is at one corner.
    struct Corner {
        Vec3 point;  ///< mm
        Vec3 du;     ///< mm per unit of u
        Vec3 dv;     ///< mm per unit of v
        Vec3 twist;  ///< mm per units of u and v
    };
    std::array<Corner, 4> corners;  ///< at (u, v) = (0,0), (1,0), (0,1), (1,1)
};

/// The Bezier form of `patch`: the same surface, B = C Q C^T. Next to a corner lie the
/// points a third of a partial inwards, and the inner one a ninth of the twist further.
/// Source: [KimChoi, section 1], which names the conversion without a formula.
///
/// \param patch in mm and units of the patch's own u and v, from 0 to 1.
/// \throws DomainError if a control point would not be finite.
/// Error of a control point below 1e-15 of the greatest number in `patch`.
BezierPatch bezier_from_ferguson(const FergusonPatch& patch);

/// The Ferguson form of `patch`: the same surface. A bicubic Bezier patch in general has
/// twists that are not zero.
///
/// \param patch in mm and units of its own u and v, from 0 to 1.
/// \throws DomainError unless the patch is bicubic and without weights.
/// Error below 1e-14 of the greatest coordinate of its control points; back in Bezier
/// form, below 2e-15 of it.
FergusonPatch ferguson_from_bezier(const BezierPatch& patch);

}  // namespace endmill
