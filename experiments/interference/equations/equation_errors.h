// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/core/angle.h"
#include "endmill/cutter/cutter.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// The errors of a normal, and of the offset point that it gives.
struct NormalErrors {
    /// Angle between tangent and normal, less 90 degrees; absolute.
    double angle_deg;
    /// Distance of the offset point from the tangent over the offset distance, less 1;
    /// absolute.
    double distance_share;
};

/// The larger of the errors.
NormalErrors worse(const NormalErrors& one, const NormalErrors& other);

/// The errors of eq. (1) and (2) as printed: N = 1/f' is the slope of the normal, and the
/// offset point lies at d (cos a, sin a) with tan a = N. \param slope of the curve.
NormalErrors printed_normal_errors(Angle slope);

/// The errors of `profile_normal`, which replaces them.
NormalErrors corrected_normal_errors(Angle slope);

/// The left side of eq. (2) is printed as a difference. Its error in mm, absolute.
/// \param x coordinate of the point on the curve. \param distance of the offset.
double left_side_error(double x, double distance);

/// Point and partial derivatives at lines x lines parameters of a surface with upward
/// normals.
std::vector<SurfaceTangents> tangents_on_grid(const Surface& surface, int lines);

/// The largest gap in mm, absolute, between a cutter at the offset of a sampled slope by
/// `plane_offset`, and the tangent of the slope at the contact.
double gap_in_plane(const Cutter& cutter);

/// The same in space: the cutter at `control_point` over each of `grid`, and the tangent
/// plane there.
double gap_in_space(const Cutter& cutter, const std::vector<SurfaceTangents>& grid);

/// The range of the distances between contact and reference point, over the radius.
double distance_spread(const Cutter& cutter, const std::vector<SurfaceTangents>& grid);

/// The deepest point in mm of a flat end mill below the tangent plane, if its offset is
/// p + R e_x or p - R e_x, away from the material, without computing the direction of the
/// normal.
double gouge_without_normal(double radius, const std::vector<SurfaceTangents>& grid);

/// The largest component of the normal of eq. (5) along the partial derivatives, over
/// their lengths.
double tangent_component(const std::vector<SurfaceTangents>& grid);

}  // namespace endmill
