// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "endmill/core/angle.h"
#include "endmill/core/vec.h"
#include "endmill/machine/rotary_limits.h"
#include "endmill/setup/setup_pose.h"
#include "endmill/visibility/visibility.h"

namespace endmill {

/// An arc of a great circle: the tool directions of a machine of one rotary axis.
struct DirectionArc {
    Vec3 axis;      ///< unit: the rotary axis
    Vec3 begin;     ///< unit, perpendicular to it: the first direction
    double length;  ///< rad, counter-clockwise about the axis; at most 2 pi
};

/// The shortest arc about `axis` within `tolerance` of which each facet has an accessible
/// cell; of arcs equally short the first counter-clockwise. Facets that no cell reaches are
/// left out of account. Exact for the centres as points: one circular sweep over the cells
/// near the circle, O(cells * facets).
/// \param centres unit, one for each cell of `map`. \param axis unit.
/// \param tolerance of directions, 0 to 45 degrees; half a cell lets any circle meet cells.
///        Rounding is forgiven, 1e-9 rad.
/// \return nothing if a facet has no cell near the circle.
/// \throws DomainError if the tolerance is outside, or unless there is a centre for each cell.
std::optional<DirectionArc> shortest_arc(const VisibilityMap& map,
                                         std::span<const Vec3> centres, const Vec3& axis,
                                         Angle tolerance);

/// The setup for a machine of four axes, whose one rotary axis is phi, by the shortest of the
/// arcs about `axes`. Its theta is [0, 0], its area 0, its status `FourAxis` (`ThreeAxis` if
/// one direction will do). The tool axis divides the arc in the ratio of the limits; r2 = C x
/// r1 completes the pose. The first of the shortest counts, to 1e-9 rad.
/// \param axes unit: candidates, such as the centres of a grid finer than the map's.
/// \return `feasible` is empty if even the shortest is longer than `limits`; `poses_skipped`
///         counts axes about which some facet has no cell.
/// \throws DomainError as `shortest_arc`, or unless `limits` hold 0 and at most 2 pi.
SetupSearch arc_search(const VisibilityMap& map, std::span<const Vec3> centres,
                       std::span<const Vec3> axes, const RotaryRange& limits,
                       Angle tolerance);

/// A tool direction and what it reaches.
struct DirectionReach {
    std::size_t cell = 0;
    std::size_t facets = 0;  ///< how many
};

/// The direction that reaches most facets, the lowest cell of equals: all that a machine of
/// three axes can do. \throws DomainError if the map has no cell.
DirectionReach widest_direction(const VisibilityMap& map);

}  // namespace endmill
