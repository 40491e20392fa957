// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

}  // namespace endmill
