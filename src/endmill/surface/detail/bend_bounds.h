// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "endmill/surface/bezier_patch.h"

namespace endmill {

/// Upper bounds of |r_uu|, |r_uv| and |r_vv| over a piece of a patch, in mm per squared
/// unit of the patch's parameters.
struct BendBounds {
    double uu;  ///< of |r_uu|
    double uv;  ///< of |r_uv|
    double vv;  ///< of |r_vv|

    /// Upper bound in mm of the distance between the surface and any triangle with
    /// corners in one cell of `width_u` by `width_v`, measured at equal parameters: (a^2
    /// uu + 2 a b uv + b^2 vv) / 8.
    /// Source: [FilipMagedsonMarkot, pp. 295-311] for right triangles. For others it is
    /// the sum of the remainders of Taylor's formula, because the coordinates of the
    /// corners have a variance of at most a quarter.
    double chord_error(double width_u, double width_v) const
    {
        return (width_u * width_u * uu + 2 * width_u * width_v * uv +
                width_v * width_v * vv) /
               8;
    }
};

/// Number of equal pieces along each parameter on which a patch is bounded.
inline constexpr int bounded_pieces = 4;

/// Bounds over the equal pieces of `patch`; piece (i, j) is at [j * bounded_pieces + i].
/// They come from convex hulls of control points, and are never too small except for
/// rounding.
std::array<BendBounds, bounded_pieces * bounded_pieces> bend_bounds(
    const BezierPatch& patch);

}  // namespace endmill
