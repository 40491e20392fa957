// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "endmill/bound/bound_problem.h"
#include "endmill/surface/curvature.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// The surfaces of a part with the signs of their normals.
struct BoundedPart {
    std::span<const Surface> surfaces;  ///< in mm
    std::span<const double> sides;      ///< from tool_side_signs
};

/// A place at which the ball may touch. At the border of two patches the patch decides
/// which of the two curvatures counts.
struct ContactPlace {
    std::size_t surface;  ///< number of the surface
    int i;                ///< patch in u
    int j;                ///< patch in v
    SurfacePoint at;      ///< in the closed patch
};

/// The place at parameters of a surface; at a border in the patch above it.
ContactPlace contact_place(const BoundedPart& part, std::size_t surface,
                           const SurfacePoint& at);

/// A contact with the frame of its principal directions.
struct ContactFrame {
    std::size_t surface;    ///< number of the surface
    SurfacePoint at;        ///< parameters of the contact
    Vec3 centre;            ///< of the ball, mm
    Vec3 e1;                ///< unit, principal direction of the least curvature
    Vec3 e2;                ///< unit, principal direction of the greatest curvature
    PrincipalCurvatures k;  ///< 1/mm
    double half_axis_1;     ///< mm, of the covered disc along e1, to second order
    double half_axis_2;     ///< mm, along e2
    TangentVector along_1;  ///< parameters of half_axis_1 e1
    TangentVector along_2;  ///< parameters of half_axis_2 e2
};

/// The frame of a contact.
/// \return nothing where the surface has no normal, or a concavity is tighter than the
///         ball.
std::optional<ContactFrame> contact_frame(const BoundedPart& part,
                                          const BoundProblem& problem,
                                          const ContactPlace& place);

/// The widest strip in mm that the ball covers per mm of the bounded length, to second
/// order: 2 max(a1, a2) for contacts, and 2 max(a1 / (1 + R k2), a2 / (1 + R k1)) for
/// tips.
double widest_strip(const ContactFrame& frame, const BoundProblem& problem);

}  // namespace endmill
