// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "endmill/core/vec.h"

namespace endmill {

/// How the half sphere about a tool axis is laid on a plane.
enum class HullProjection {
    Gnomonic,     ///< from the centre: great circles become straight lines
    Orthographic  ///< along the tool axis: directions of equal height are on straight lines
};

/// Two directions that are exactly perpendicular to `axis`, of any length, and independent:
/// a coordinate of the axis twice, once with changed sign, and 0.
/// \throws DomainError if the axis is 0.
std::array<Vec3, 2> exact_perpendiculars(const Vec3& axis);

/// Whether all of `directions` lie less than 90 degrees from `axis`, exactly.
bool is_in_open_hemisphere(const Vec3& axis, std::span<const Vec3> directions);

/// The vertices of the convex hull of the images of `tool_axis` and `directions`, counter-
/// clockwise about the tool axis, no three on one line. Which are vertices is decided exactly
/// for the given doubles; of directions with one image a single one is given. If all images
/// are on one line, its two ends; if there is only the tool axis, that.
/// The monotone chain, O(n log n).
/// \throws DomainError if the axis is 0, or if, in the gnomonic projection, a direction is not
///         within 90 degrees of it.
std::vector<Vec3> spherical_hull(const Vec3& tool_axis, std::span<const Vec3> directions,
                                 HullProjection projection);

/// The same hull in the gnomonic projection by the paper's construction, which adds the
/// directions one by one, the nearest first. O(n h) for h vertices.
/// Source: [KangSuh, section 6, eq. (14)].
/// \throws DomainError as `spherical_hull`.
std::vector<Vec3> incremental_hull(const Vec3& tool_axis,
                                   std::span<const Vec3> directions);

}  // namespace endmill
