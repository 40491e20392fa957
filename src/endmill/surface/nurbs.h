// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "endmill/surface/surface.h"

namespace endmill {

/// One parameter of a B-spline surface.
struct SplineParameter {
    int degree;                 ///< p, 1 … 25
    std::vector<double> knots;  ///< not falling, p + 1 more than control points

    /// Number of control points along this parameter.
    int points() const { return static_cast<int>(knots.size()) - degree - 1; }
};

/// A NURBS surface by its numbers.
struct Nurbs {
    SplineParameter u;
    SplineParameter v;
    std::vector<Vec3> control_points;  ///< mm, u running fastest
    std::vector<double> weights;       ///< one a control point; empty: all the same
};

/// What is wrong with `parameter`, for a message; empty if nothing is: the degree is in
/// 1 … 25; the knots are finite and do not fall; none is repeated more than degree + 1
/// times; there are at least degree + 1 control points; the range from knot [degree] to
/// knot [points] is within 1e-50 … 1e50; and its spans are wider than 1e-12 of it.
std::string flaw(const SplineParameter& parameter);

/// The surface of `nurbs` over its own knot range, from knot [degree] to knot [points]:
/// its Bezier patches, one a span between different knots. A knot repeated degree + 1
/// times parts it.
/// Source: blossoms of the spans; control points are right to a few roundings.
/// \throws DomainError if a parameter has a `flaw`, or as BezierPatch does.
Surface nurbs_surface(const Nurbs& nurbs, ToolSide tool_side = ToolSide::Up);

/// The graph (u, v, z(u, v)) of the C2 bicubic spline that takes the heights of a grid,
/// with the not-a-knot condition at its four sides: what is between the first two
/// intervals of a line, and between the last two, is one cubic. Along a parameter with 3
/// or 2 grid lines it is quadratic or linear. u is x and v is y, in mm.
///
/// \param x rising, at least 2 of them, in mm.
/// \param y rising, at least 2 of them, in mm.
/// \param z in mm, x running fastest: z(x[i], y[j]) at [j * x.size() + i].
/// \throws DomainError if the sizes disagree, or x and y are not finite and rising by more
/// than `least_grid_interval`, or a height is not finite.
/// Polynomials up to bicubic are reproduced; heights to 1e-13 of the greatest where
/// neighbouring intervals differ by less than a factor of ten.
/// Source: tensor product of de Boor's not-a-knot spline.
Surface height_grid(std::span<const double> x, std::span<const double> y,
                    std::span<const double> z, ToolSide tool_side = ToolSide::Up);

}  // namespace endmill
