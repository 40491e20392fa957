// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "endmill/path/tool_path.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// The farthest that a part's line lies on one side of what the ball sweeps.
struct LineDeviation {
    double greatest_mm = 0;  ///< 0 if it never does
    SurfacePoint at{};       ///< where
    int patch = 0;           ///< of a part of several surfaces: on which, from 0
};

/// How far the ball's straight motions stray from the lines that they should follow.
struct MotionError {
    LineDeviation gouge;  ///< the line inside what the ball takes away
    LineDeviation left;   ///< the line outside, under material that stays
    double bound_mm;      ///< the true values are greater by this at most

    /// The greater of the two, in mm.
    double greatest_mm() const;
};

/// Measures the cuts of `path`: the deviation of a point of the pass's line is its
/// distance from the boundary of what the ball sweeps on the straight move beside it, the
/// capsule around the centres. All points count: intervals of the line are halved until
/// the bound on its second derivative leaves nothing open, to 1e-6 of the radius.
/// \param along the parameter along which the passes run.
/// \pre the contacts of a pass share their other parameter; the path's patches are
/// numbers of `surfaces`.
/// Source: [KimChoi, section 4.1] bounds the chord between contacts only; convex lines
/// are gouged deeper than that by 1 + R / rho.
MotionError motion_error(std::span<const Surface> surfaces, const ToolPath& path,
                         const BallCutter& cutter, Parameter along);

}  // namespace endmill
