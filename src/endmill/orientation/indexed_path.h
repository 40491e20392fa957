// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "endmill/core/vec.h"
#include "endmill/path/tool_path.h"

/// \file
/// Joins paths with fixed axes to one path, on which the tool turns in the air (3+2 axes).

namespace endmill {

/// A ball around the stock, outside which the tool turns.
struct ClearBall {
    Vec3 centre;    ///< mm
    double radius;  ///< mm, above 0
};

/// A path with one axis.
struct IndexedStretch {
    ToolPath path;       ///< its axis is constant; it begins with a plunge; not empty
    double safe_height;  ///< mm along its axis: from there rapids are clear
};

/// Greatest turn of the axis between two points in the air, degrees.
inline constexpr double turning_step_deg = 5;

/// Joins stretches in their order.
///
/// Between two stretches the tool is lifted along its axis to the safe height, and as a rapid
/// until its tip is beyond the ball, with the ball's centre below it along the axis. There it
/// moves over the centre and turns about it on the great arc, by at most `turning_step_deg` from
/// point to point; opposite axes turn about a perpendicular one. Then it moves over the first
/// point of the next stretch and down to the safe height. The plane through the tip across
/// the axis, above which the whole tool is, stays clear of the ball all the time.
///
/// At the end the tool is lifted to the safe height of the last stretch. A program rounds
/// positions, and a rapid from a cut could remove as much.
///
/// Passes are numbered through all stretches. The moves between two stretches have the number
/// of the pass that they lead to.
/// Source: docs/methods/five-axis-planning.md, section 6.
/// \throws DomainError unless the radius is above 0, no stretch is empty and every axis is
///         constant.
/// \throws GeometryError if a stretch rises above its safe height.
ToolPath indexed_path(std::span<const IndexedStretch> stretches, const ClearBall& ball);

}  // namespace endmill
