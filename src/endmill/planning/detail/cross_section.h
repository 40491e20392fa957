// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "endmill/surface/curvature.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// The frame of a pass along u at a contact: where the cutter feeds, and where the next
/// pass lies.
struct FeedFrame {
    SurfacePoint at;         ///< parameters of the contact
    SurfaceJet jet;          ///< there
    FundamentalForms forms;  ///< with the normal N on the tool's side
    Vec3 feed;               ///< T_s, unit, along du; at a pole of the pass along duv
    Vec3 cross_feed;         ///< T_c = +-N x T_s, unit, on the side of dv
    TangentVector cross;     ///< components of T_c in du and dv
    bool passes_meet;  ///< dv vanishes: T_c has no components, every pass comes here
};

/// The frame at `at`, whose jet is `jet`.
/// \param side from tool_side_sign.
/// \throws GeometryError where the surface has no normal.
/// Source: [KimChoi, section 4.2], T_c = N x T_s where the print has T_1 = N x T_0.
FeedFrame feed_frame(const SurfacePoint& at, const SurfaceJet& jet, double side);

/// The frame with a normal that is already known, at a pole as a limit.
FeedFrame feed_frame(const SurfacePoint& at, const SurfaceJet& jet, const Vec3& normal);

/// A place of the surface in the check plane, which stands at the contact across the
/// feed.
struct CheckPlanePoint {
    SurfacePoint at;
    bool converged;  ///< if not, `at` is the linear estimate
    int iterations;  ///< Newton steps taken
};

/// The place in the check plane that lies `distance` from the contact, measured along
/// T_c: (r - r_c).T_s = 0 and (r - r_c).T_c = distance, by Newton's method to 1e-12 of
/// the surface's diagonal, steps held to 0.3 of a patch, at most 8 of them. Beyond the
/// ends of the surface the polynomials of its border patches go on.
/// Source: [KimChoi, eq. (9), (10)]; eq. (6), (7) are the same with a small distance.
/// \param distance in mm.
/// \param most_v   the search ends, not converged, once v is sure to lie beyond if steps
///                 go on to halve at least: the place is then of no interest.
CheckPlanePoint check_plane_point(
    const Surface& surface, const FeedFrame& frame, double distance,
    double most_v = std::numeric_limits<double>::infinity());

/// Normal curvature in 1/mm across the feed at the contact, by the second fundamental
/// form; positive where the part is convex.
double cross_curvature(const FeedFrame& frame);

/// The same by the chord to the surface's point in the check plane `step` away: -2
/// N.(r_eps - r_c) / |r_eps - r_c|^2. On a section of curvature k2 and third derivative
/// k3 its error is k3 step / 3; exact on circles.
/// Source: [KimChoi, eq. (8)]. The paper does not print its step.
/// \param step in mm, positive; below 1e-6 of the surface's size it cancels.
double cross_curvature_by_chord(const Surface& surface, const FeedFrame& frame,
                                double step);

}  // namespace endmill
