// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/core/vec.h"
#include "endmill/machine/axis_limits.h"
#include "endmill/setup/setup_pose.h"
#include "endmill/visibility/visibility.h"

/// \file
/// Setups on machines with one rotary axis or none.
/// Source: docs/methods/five-axis-setup.md, section 10.

namespace endmill {

/// An arc of a great circle: the tool directions of a machine with one rotary axis.
struct DirectionArc {
    Vec3 axis;      ///< unit: the rotary axis
    Vec3 begin;     ///< unit, perpendicular to the axis: the first direction
    double length;  ///< rad, counter-clockwise about the axis; at most 2 pi
};

/// Finds the shortest arc about an axis such that each facet has an accessible cell
/// within `tolerance` of it. Of equally short arcs the first one counter-clockwise wins.
/// Facets that no cell reaches are left out. Exact for the cell centres as points.
/// O(cells * facets).
/// \param map cones of the facets. \param centres unit, one for each cell of `map`.
/// \param axis unit.
/// \param tolerance 0 to 45 degrees; with half a cell every circle meets cells. 1e-9 rad
///         is added for rounding.
/// \return nothing if a facet has no cell close to the circle.
/// \throws DomainError if the tolerance is outside its range, or if there is not one
///         centre for each cell.
std::optional<DirectionArc> shortest_arc(const VisibilityMap& map,
                                         std::span<const Vec3> centres, const Vec3& axis,
                                         Angle tolerance);

/// Finds the setup for a machine of four axes from the shortest of the arcs about some
/// axes.
///
/// The only rotary axis is phi; theta is [0, 0] and the area is 0. The status is
/// `FourAxis`, or `ThreeAxis` if one direction suffices. The tool axis divides the arc in
/// the ratio in which 0 divides the limits, and r2 = C x r1. Of arcs that are equally
/// short, to 1e-9 rad, the first one wins.
/// \param map cones of the facets. \param centres unit, one for each cell.
/// \param axes unit: candidates of the rotary axis. \param limits turns.
/// \param tolerance as in `shortest_arc`.
/// \return `feasible` is empty if the shortest arc is longer than `limits`;
///         `poses_skipped` counts axes without an arc.
/// \throws DomainError as `shortest_arc`, or if `limits` do not contain 0 or exceed 2 pi.
PoseSearchResult arc_search(const VisibilityMap& map, std::span<const Vec3> centres,
                            std::span<const Vec3> axes, const RotaryRange& limits,
                            Angle tolerance);

/// The pose of the shortest arc about each of some axes, as `arc_search` fits it.
/// \param map, centres, axes, limits, tolerance as for `arc_search`.
/// \return in the order of the axes; an axis without an arc, or with one that is longer
///         than `limits`, is left out.
/// \throws DomainError as `arc_search`.
std::vector<FittedPose> arcs_within_limits(const VisibilityMap& map,
                                           std::span<const Vec3> centres,
                                           std::span<const Vec3> axes,
                                           const RotaryRange& limits, Angle tolerance);

/// A tool direction and the facets that it reaches.
struct DirectionReach {
    std::size_t cell = 0;    ///< its centre is the direction
    std::size_t facets = 0;  ///< number of facets reached
};

/// Finds the direction that reaches the most facets, which is the best setup of a machine
/// of three axes. Of equal directions the lowest cell wins. \throws DomainError if the
/// map has no cell.
DirectionReach widest_direction(const VisibilityMap& map);

}  // namespace endmill
