// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>

#include "endmill/planning/detail/marched_surface.h"
#include "endmill/planning/planner_options.h"

namespace endmill {

/// The parameter of the next pass according to one contact of a pass.
struct PassCandidate {
    double v;              ///< parameter of the next pass
    SurfacePoint at;       ///< parameters of the contact
    SurfacePoint partner;  ///< its neighbour (u*, v*) on the next pass; v* is `v`
};

/// Where the pass after a pass lies.
struct NextPass {
    /// Its parameter; infinite if no contact limits it.
    double v = std::numeric_limits<double>::infinity();
    /// The candidate that determined `v`; none for Governing::Mean and without a limit.
    std::optional<PassCandidate> governing;
};

/// A pass and its successor.
struct MarchedPass {
    Pass contacts;                 ///< with rising u
    std::optional<NextPass> next;  ///< none if the pass is the last
};

/// Whether a pass has a successor.
enum class PassRole {
    Followed,  ///< the next pass is computed
    Last,      ///< only the contacts are computed
};

/// Computes the pass along u at `v` with the longest steps that keep the chord tolerance,
/// and by the rule `options.governing` the parameter of the next pass.
///
/// * Length of a step and its projection on the feed. Source: [KimChoi, eq. (1), (2)].
/// * End of the step on the line. Source: [KimChoi, eq. (3)].
/// * Path interval and its projection across the feed. Source: [KimChoi, eq. (4), (5)].
/// * Curvature across the feed by a chord. Source: [KimChoi, eq. (6), (7), (8)].
/// * Neighbour of a contact on the next pass. Source: [KimChoi, eq. (9), (10)].
///
/// \param marched the surface. On a collapsed edge the pass is one contact if its normals
///                have one limit.
/// \param v       parameter of the pass.
/// \param role    whether to compute the next pass.
/// \param cutter  the ball.
/// \param options see there.
/// \throws GeometryError with the place where the ball does not fit, the surface has no
///         normal, or a step makes no progress.
/// \throws LimitError if the pass has more than `options.most_points` points.
MarchedPass march_pass(const MarchedSurface& marched, double v, PassRole role,
                       const BallCutter& cutter, const IsoParametricOptions& options);

}  // namespace endmill
