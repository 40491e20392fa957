// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "endmill/surface/bezier_patch.h"

namespace endmill {

/// Bounds on |r_uu|, |r_uv| and |r_vv| over a piece of a patch, in mm per unit of the
/// patch's parameters squared.
struct BendBounds {
    double uu;
    double uv;
    double vv;

    /// A bound in mm on the distance of the surface from any triangle whose corners lie
    /// in one cell of `width_u` by `width_v`, measured at equal parameters:
    /// (a^2 uu + 2 a b uv + b^2 vv) / 8.
    /// Source: as Filip, Magedson and Markot's for right triangles; for others the sum of
    /// Taylor's remainders, the corners' coordinates having a variance below a quarter.
    double chord_error(double width_u, double width_v) const
    {
        return (width_u * width_u * uu + 2 * width_u * width_v * uv +
                width_v * width_v * vv) /
               8;
    }
};

/// The patch is bounded in this many equal pieces along each parameter.
inline constexpr int bounded_pieces = 4;

/// Bounds over the equal pieces of `patch`, piece (i, j) at [j * bounded_pieces + i]:
/// from the hulls of control points, so never too small but for rounding.
std::array<BendBounds, bounded_pieces * bounded_pieces> bend_bounds(
    const BezierPatch& patch);

}  // namespace endmill
