// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "endmill/surface/surface.h"

/// \file
/// NURBS surfaces, and surfaces through a grid of heights. Implemented in `nurbs.cpp` and
/// `height_grid.cpp` (height_grid).

namespace endmill {

/// Degree and knots of one parameter of a B-spline surface.
struct SplineParameter {
    int degree;                 ///< p, 1 to 25
    std::vector<double> knots;  ///< in non-falling order, p + 1 more than control points

    /// Number of control points along this parameter.
    int points() const { return static_cast<int>(knots.size()) - degree - 1; }
};

/// A NURBS surface, given by its numbers.
struct Nurbs {
    SplineParameter u;                 ///< parameter u
    SplineParameter v;                 ///< parameter v
    std::vector<Vec3> control_points;  ///< mm, u varying fastest
    std::vector<double> weights;  ///< one for each control point; empty if all are equal
};

/// The error of a spline parameter, as text for a message; empty if the parameter is
/// valid. It is valid if:
/// - the degree is from 1 to 25, and there are at least degree + 1 control points;
/// - the knots are finite and in non-falling order, and none is repeated more than degree
///   + 1 times;
/// - the range from knot [degree] to knot [points] is within 1e-50 to 1e50;
/// - every span between different knots is wider than 1e-12 of the range.
std::string flaw(const SplineParameter& parameter);

/// The surface of `nurbs` over its knot range, from knot [degree] to knot [points]. Each
/// span between different knots becomes a Bezier patch. The surface has a gap at a knot
/// that is repeated degree + 1 times. Control points are accurate to a few roundings.
/// They are values of the polar form (blossom) of the span.
/// \param nurbs with valid parameters; see `flaw`.
/// \param tool_side as in Surface.
/// \throws DomainError if a parameter has a `flaw`, the numbers of points or weights do
///         not match, or a point or weight is not valid for BezierPatch.
Surface nurbs_surface(const Nurbs& nurbs, ToolSide tool_side = ToolSide::Up);

/// A surface as one NURBS with the same parameters: each Bezier patch between full knots. Control
/// points that neighbours share stand once. `nurbs_surface` gives the same patches, those of
/// rational ones to a few roundings.
/// \throws DomainError for patches of different degrees.
Nurbs nurbs_of(const Surface& surface);

/// The surface (u, v, z(u, v)) of the C2 bicubic spline that interpolates the heights of
/// a grid, where u is x and v is y, in mm.
///
/// At its four sides the spline satisfies the not-a-knot condition: the first two
/// intervals of a grid line share one cubic, and so do the last two. Along a parameter
/// with 3 grid lines the spline is quadratic, and with 2 grid lines linear. Bicubic
/// polynomials are reproduced. Heights are accurate to 1e-13 of the greatest one if
/// neighbouring intervals differ by less than a factor of ten.
/// Source: [DeBoor, chapter IV] for one variable; here its tensor product.
///
/// \param x rising, at least 2 numbers, in mm.
/// \param y rising, at least 2 numbers, in mm.
/// \param z in mm, x varying fastest: z(x[i], y[j]) at [j * x.size() + i].
/// \param tool_side as in Surface.
/// \throws DomainError if the sizes do not match, x and y are not finite and rising by
///         more than `least_grid_interval` of their range, or a height is not finite.
Surface height_grid(std::span<const double> x, std::span<const double> y,
                    std::span<const double> z, ToolSide tool_side = ToolSide::Up);

}  // namespace endmill
