// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

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

/// Numbers of times that a patch is halved along its parameters, 0 or more.
struct Halvings {
    int u;  ///< gives 2^u columns
    int v;  ///< gives 2^v rows
};

/// Halvings along each parameter that give the pieces of a whole patch.
inline constexpr int bounded_halvings = 2;
/// Number of these pieces along each parameter.
inline constexpr int bounded_pieces = 1 << bounded_halvings;

/// Bounds over equal pieces of `patch`; piece (i, j) is at [j * 2^halvings.u + i]. They
/// come from convex hulls of control points, and are never too small except for rounding.
/// The smaller the pieces, the closer the bounds; they converge to the greatest lengths
/// over a piece, with weights too.
std::vector<BendBounds> bend_bounds(const BezierPatch& patch,
                                    const Halvings& halvings = {bounded_halvings,
                                                                bounded_halvings});

}  // namespace endmill
