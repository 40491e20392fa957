// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "endmill/planning/detail/verified_pass.h"
#include "endmill/planning/linking.h"

namespace endmill {

/// What a verified plan must keep.
struct VerifiedOptions {
    Parameter direction = Parameter::U;  ///< along which the passes run
    MotionTolerances tolerances{0.5, 0.5};
    double scallop_height = 0.5;           ///< h between passes, mm
    bool stop_at_borders = false;          ///< a CL point on every patch border
    LinkOptions link = {};                 ///< order, tool axis, safe height
    std::size_t most_points = 40'000'000;  ///< beyond it LimitError is thrown
    std::function<void(double share)> progress = {};  ///< called now and then, if set
};

/// A place under more material than the tolerances allow, or that could not be shown to
/// be under less: in a crease that no ball reaches, say. One for each pair of neighbouring
/// passes at most.
struct UncoveredPlace {
    int patch;  ///< number of its surface
    SurfacePoint at;
    Vec3 point;  ///< mm
};

/// A path and what it could not keep.
struct VerifiedPlan {
    ToolPath path;
    std::size_t lifted_links = 0;  ///< links of the zigzag that would have gouged
    std::vector<UncoveredPlace> uncovered = {};
};

/// Plans passes along iso-parametric lines from one border of each surface to the other,
/// by the ball's true motion along straight moves:
///
/// * no move, links and plunges included, enters any of the surfaces deeper than the inner
///   tolerance, nor does the shank; nor takes more along the normals at the border, where
///   the ball reaches under the part;
/// * beside each move its line is under no more material than the outer tolerance, and
///   between passes the surface under no more than scallop height and outer tolerance
///   together, but for the places in `uncovered`.
///
/// Both are bounded, not sampled. Steps are the longest that do, to a thousandth; passes
/// lie as far apart as balls that roll along them would leave the scallop height, to a
/// thousandth, first and last on a border. Where that does not hold once the steps are
/// straight, a step is halved, or a pass laid between, down to an eighth of the interval.
/// A zigzag starts at that end of its first pass from which its links are shorter.
/// Surfaces follow each other in their order, joined by lifted links.
///
/// \throws DomainError if a tolerance, the scallop height or the axis is out of range.
/// \throws GeometryError, with the place, where N . axis <= 0, the surface has no normal,
/// or the ball fits nowhere.
/// \throws LimitError if the path has more than `most_points` points.
/// The same path, to the bit, with any number of threads.
VerifiedPlan plan_verified(std::span<const Surface> surfaces, const BallCutter& cutter,
                           const VerifiedOptions& options);

}  // namespace endmill
