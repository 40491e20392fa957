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
/// The planner whose path keeps its tolerances everywhere on the surface, proved by
/// bounds.

namespace endmill {

/// A place where more material remains than the options allow, or may remain because the
/// bounds could not exclude it. An example is a crease that no ball reaches. The planner
/// reports at most one place for each pair of neighbouring passes.
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
    std::vector<UncoveredPlace> uncovered = {};  ///< empty if the whole part is finished
};

/// Plans passes along iso-parametric lines from one border of each surface to the other.
/// It judges the straight moves of the ball, not only their contacts:
///
/// * No move, including links and plunges, and no part of the shank enters a surface
///   deeper than the inner tolerance. At the border of the part, where the ball reaches
///   below it, the depth along the border's normals is limited as well.
/// * Beside each move, at most the outer tolerance of material remains on the line of the
///   pass. Between passes at most the scallop height plus the outer tolerance remains,
///   except at the places in `uncovered`.
///
/// Both statements are proved by bounds over whole surface cells, not by samples. Each
/// step is the longest that satisfies them, to a thousandth of its length. The intervals
/// are the widest at which balls that roll along the passes keep the scallop height, to a
/// thousandth; the first and the last pass lie on borders. If straight steps then break a
/// limit between two passes, the planner halves a step or inserts a pass, down to an
/// eighth of the interval. A zigzag starts at the end of its first pass that makes the
/// links shorter. Surfaces are planned in their order and joined by lifted links.
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
