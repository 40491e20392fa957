// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/path/tool_path.h"
#include "endmill/planning/planner_options.h"
#include "endmill/surface/surface.h"

/// \file
/// The planner that keeps its tolerances everywhere on the surface and proves this by
/// bounds.

namespace endmill {

/// A place where more stock remains than the options allow, or where the bounds could not
/// exclude it. An example is a crease that no ball reaches. The planner reports at most
/// one place for each pair of neighbouring passes.
struct UncoveredPlace {
    int patch;        ///< number of the surface, from 0
    SurfacePoint at;  ///< parameters on it
    Vec3 point;       ///< mm
};

/// A planned path, and the places at which it does not keep the options.
struct VerifiedPlan {
    ToolPath path;  ///< all passes and the links between them
    /// Number of links that are lifted because a straight link would gouge.
    std::size_t lifted_links = 0;
    std::vector<UncoveredPlace> uncovered = {};  ///< empty: the limits are proved
};

/// Plans passes along iso-parametric lines from one border of each surface to the other.
/// It tests the whole straight motion of the ball, not only the contact points:
///
/// * No move enters a surface deeper than the inner tolerance. This holds for links,
///   plunges and the shank too. At the border of the part the ball may reach below the
///   surface. There the inner tolerance also limits the depth along the border's normals.
/// * On the line of a pass, at most the outer tolerance of stock remains. Between passes,
///   at most the scallop height plus the outer tolerance remains, except at the places in
///   `uncovered`.
///
/// Both statements are proved by bounds over whole surface cells, not by samples. Each
/// step is the longest that satisfies them, to a thousandth of its length.
///
/// One of the two tolerances may be 0. Contacts then do not lie on the surface: they are
/// moved along its normal to one of the two limits, so that the chord of a step deviates
/// to the allowed side only. See contact_offsets in detail/verified_pass.h.
///
/// The path interval is the largest at which a ball in continuous contact keeps the
/// scallop height, to a thousandth. The first and the last pass lie on borders. Straight
/// steps may break a limit between two such passes. The planner then halves a step or
/// inserts a pass. It inserts passes until their spacing is one eighth of the interval.
///
/// A zigzag starts at that end of the first pass for which the total length of the links
/// is smaller. Surfaces are planned in their order and joined by lifted links.
///
/// The result is the same to the bit for any number of threads.
/// \param surfaces the part; at least one.
/// \param cutter the ball.
/// \param options see there.
/// \throws DomainError if a tolerance, the scallop height or the axis is out of range.
/// \throws GeometryError with the place if N . axis <= 0 or the surface has no normal;
///         and if the ball fits nowhere.
/// \throws LimitError if the path has more than `most_points` points.
VerifiedPlan plan_verified(std::span<const Surface> surfaces, const BallCutter& cutter,
                           const VerifiedOptions& options);

}  // namespace endmill
