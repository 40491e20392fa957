// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "endmill/surface/curvature.h"
#include "endmill/surface/surface.h"

/// \file
/// The section of a surface by the check plane, which stands at a contact across
/// the feed.

namespace endmill {

/// The frame of a pass along u at one of its contacts.
struct FeedFrame {
    SurfacePoint at;         ///< parameters of the contact
    SurfaceJet jet;          ///< of the surface at the contact
    FundamentalForms forms;  ///< with the normal N on the tool's side
    Vec3 feed;               ///< T_s, unit, along du; along duv if the pass is a pole
    Vec3 cross_feed;         ///< T_c = +-N x T_s, unit, on the side of dv
    TangentVector cross;     ///< components of T_c in du and dv
    /// Whether dv vanishes, because all passes meet at the contact. Then T_c has no
    /// components, and `cross` is zero.
    bool passes_meet;
};

/// The frame at a contact.
/// \param at   parameters of the contact.
/// \param jet  of the surface at `at`.
/// \param side from tool_side_sign.
/// \throws GeometryError where the surface has no normal.
/// Source: [KimChoi, section 4.2], with T_c = N x T_s where the print has T_1 = N x T_0.
FeedFrame feed_frame(const SurfacePoint& at, const SurfaceJet& jet, double side);

/// The frame at a contact whose normal is known, for example as a limit at a pole.
/// \param at     parameters of the contact.
/// \param jet    of the surface at `at`.
/// \param normal N, unit, on the tool's side.
FeedFrame feed_frame(const SurfacePoint& at, const SurfaceJet& jet, const Vec3& normal);

/// A point of the surface in the check plane.
struct CheckPlanePoint {
    SurfacePoint at;  ///< parameters; the linear estimate if not converged
    bool converged;   ///< whether Newton's method reached its tolerance
    int iterations;   ///< Newton steps taken
};

/// The point of the surface in the check plane at a given distance from the contact along
/// T_c: (r - r_c).T_s = 0 and (r - r_c).T_c = distance. Newton's method takes at most 8
/// steps of at most 0.3 of a patch, until the residual is 1e-12 of the surface's
/// diagonal. Beyond the ends of the surface the polynomials of the border patches are
/// continued.
/// Source: [KimChoi, eq. (9), (10)]; eq. (6), (7) are the same with a small distance.
/// \param surface  of the frame.
/// \param frame    at the contact.
/// \param distance in mm.
/// \param most_v   points beyond it are not needed: the search ends without convergence
///                 once the remaining steps, if each is at most half as long as the one
///                 before, cannot lead back to it.
CheckPlanePoint check_plane_point(
    const Surface& surface, const FeedFrame& frame, double distance,
    double most_v = std::numeric_limits<double>::infinity());

/// Normal curvature in 1/mm across the feed at the contact, from the second fundamental
/// form. It is positive where the part is convex.
/// Source: docs/methods/economic-cl-data.md, section 6.
double cross_curvature(const FeedFrame& frame);

/// Normal curvature in 1/mm across the feed, from the chord to a point r_eps of the
/// surface in the check plane: -2 N.(r_eps - r_c) / |r_eps - r_c|^2. It is exact on
/// circles. On a section with third derivative k3 its error is about k3 step / 3.
/// Source: [KimChoi, eq. (8)]. The paper does not print its step.
/// \param surface of the frame.
/// \param frame   at the contact.
/// \param step    distance of r_eps in mm, positive; below 1e-6 of the surface's size the
///                difference cancels.
double cross_curvature_by_chord(const Surface& surface, const FeedFrame& frame,
                                double step);

}  // namespace endmill
