// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "endmill/bound/bound_problem.h"
#include "endmill/bound/detail/simple_shape.h"
#include "endmill/core/angle.h"

/// \file
/// The bound in closed form, on planes, spheres and circular cylinders. All values have
/// relative errors below 1e-12.
/// Source: docs/methods/path-length-bound.md, section 5.

namespace endmill {

/// A constant density and the integral of it over the covered set D(x).
struct ClosedDensity {
    double density_per_mm;  ///< g, 1/mm
    double disc_mm;         ///< G, mm
};

/// The density on a plane. With the flank of the tool it depends on the slope: above
/// asin((R - h) / (R + gamma)) the flank covers uphill more than the ball.
/// \param problem cutter, tolerances and tool.
/// \param slope angle between normal and tool axis, below 90 degrees with the flank.
/// \throws DomainError if the slope is out of this range, or the problem not valid.
ClosedDensity plane_density(const BoundProblem& problem, const Angle& slope);

/// The density on a sphere, for the ball. For tips with gamma > 0 it includes the factor
/// by which centres that stray are shorter.
/// \param problem cutter, tolerances and length.
/// \param curvature one over the radius, positive if convex; 1/mm.
/// \return nothing if the ball does not fit a concave sphere, or covers more than a
///         hemisphere.
/// \throws DomainError if the problem is not valid or the curvature 0.
std::optional<ClosedDensity> sphere_density(const BoundProblem& problem,
                                            double curvature);

/// The density on a circular cylinder, likewise.
std::optional<ClosedDensity> cylinder_density(const BoundProblem& problem,
                                              double curvature);

/// The slope up to which the ball alone decides what an upright tool covers on a sphere or
/// across a cylinder.
/// \param problem cutter and tolerances.
/// \param curvature as for `sphere_density`.
/// \return nothing where `sphere_density` returns nothing.
std::optional<Angle> steepest_without_flank(const BoundProblem& problem,
                                            double curvature);

/// The closed density of a shape, if its slopes are within the limit of the closed form.
/// \param problem with either tool; the ball alone has no limit.
/// \param shape from `simple_shape`.
/// \return nothing on steeper shapes.
std::optional<ClosedDensity> closed_density(const BoundProblem& problem,
                                            const SimpleShape& shape);

}  // namespace endmill
