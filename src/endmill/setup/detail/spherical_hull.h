// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "endmill/core/vec.h"

/// \file
/// Convex hulls of directions about a tool axis, decided exactly.

namespace endmill {

/// The projection of the half sphere about a tool axis to a plane.
enum class HullProjection {
    Gnomonic,     ///< from the centre: great circles become straight lines
    Orthographic  ///< along the tool axis: parallels about a cross axis become lines
};

/// Two linearly independent vectors that are exactly perpendicular to `axis`. Each is
/// made of two coordinates of the axis, one of them negated, and 0.
/// \throws DomainError if the axis is 0.
std::array<Vec3, 2> exact_perpendiculars(const Vec3& axis);

/// Tests exactly whether all of `directions` are less than 90 degrees from `axis`.
bool is_in_open_hemisphere(const Vec3& axis, std::span<const Vec3> directions);

/// The vertices of the convex hull of the images of `tool_axis` and `directions`,
/// counter- clockwise about the tool axis. No three vertices are collinear.
///
/// The vertices are exact for the given doubles. Directions with the same image give one
/// vertex. If all images are collinear the result is the two ends; if all are equal it is
/// one vertex. The method is the monotone chain, O(n log n).
/// \param tool_axis any length. \param directions any length. \param projection of the
///         images.
/// \throws DomainError if the axis is 0, or if a direction is 90 degrees or more from it
///         in the gnomonic projection.
std::vector<Vec3> spherical_hull(const Vec3& tool_axis, std::span<const Vec3> directions,
                                 HullProjection projection);

/// The hull in the gnomonic projection by the paper's construction, which adds one
/// direction after the other, the nearest to the tool axis first. O(n h) for h vertices.
/// Source: [KangSuh, section 6, eq. (14)].
/// \param tool_axis any length. \param directions any length.
/// \throws DomainError as `spherical_hull`.
std::vector<Vec3> incremental_hull(const Vec3& tool_axis,
                                   std::span<const Vec3> directions);

}  // namespace endmill
