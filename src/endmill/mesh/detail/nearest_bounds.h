// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "endmill/core/vec.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// \file
/// Lower bounds of the distances from a place to parts of a mesh, for `TriangleTree`. Four
/// parts are bounded together in the widest registers of the processor.
///
/// No bound is above the squared distance, in mm^2, for coordinates of up to 1e30 mm.

/// What encloses four parts of a mesh, rounded outwards. A part is in its box and in its
/// slab, all x with slab_low <= normal . x <= slab_high. A smooth part of a mesh fits a
/// slab far more closely than a box. A part that is missing has an empty box.
struct alignas(64) FourEnclosures {
    std::array<Eigen::Array4f, 3> low;     ///< of the boxes, along each axis, in mm
    std::array<Eigen::Array4f, 3> high;    ///< mm
    std::array<Eigen::Array4f, 3> normal;  ///< of the slabs; about 1 long, or 0
    Eigen::Array4f slab_low;               ///< mm
    Eigen::Array4f slab_high;              ///< mm

    /// Four missing parts.
    FourEnclosures();

    /// The box of one part.
    Eigen::AlignedBox3d box_of(Eigen::Index part) const;
    /// The normal of the slab of one part.
    Vec3 normal_of(Eigen::Index part) const;
};

/// Bounds for four parts; infinite for a missing part.
/// \param margin in mm, more than the rounding errors of the enclosed coordinates.
/// \param limit  in mm^2. Where fewer than two boxes are within it, the bounds are those
///               of the boxes; otherwise, those of boxes and slabs.
std::array<double, 4> bound_squares(const FourEnclosures& parts, const Vec3& place,
                                    double margin, double limit);

/// Bounds for four triangles. The parameters are as above.
std::array<double, 4> bound_squares(std::span<const Vec3> points,
                                    const std::array<Triangle, 4>& triangles,
                                    const Vec3& place, double margin);

}  // namespace endmill
