// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/surface/surface.h"

/// \file
/// Continuity of surfaces at the borders of their patches. Implemented in
/// `continuity.cpp` and `patch_borders.cpp` (the borders of a part).

namespace endmill {

/// The continuity of two patches at their common border.
enum class Continuity {
    None,  ///< there is a gap
    G0,    ///< the patches share their border
    G1,    ///< the patches share their border and the normals there
};

/// The name of a continuity: "none", "G0" or "G1".
std::string_view continuity_name(Continuity continuity);

/// The worst place of a border between two patches.
struct BorderBreak {
    SurfacePoint at = {};               ///< the place, on the border
    Vec3 point = Vec3::Zero();          ///< mm
    Angle normals = Angle::radians(0);  ///< angle between the normals of the two patches
    double gap_mm = 0;  ///< mm, between their points at the same parameters
    Continuity continuity = Continuity::G1;  ///< of the whole border
    std::size_t surface = 0;  ///< number of the surface in a part of several, from 0
};

/// The continuity of a border with a gap in mm and an angle between normals, on a part of
/// `size` mm: G0 if the gap is at most 1e-9 of the size, G1 if moreover the angle is at
/// most `smooth_angle`.
Continuity continuity_of(double gap_mm, Angle normals, double size);

/// Whether `one` is the worse break. The break of lower continuity is worse; at equal
/// continuity it is the one with the greater gap or angle.
bool is_worse(const BorderBreak& one, const BorderBreak& other);

/// The worst place of every inner border of a surface: first the borders across u, then
/// those across v. Each border is examined at 17 samples, ends included. Samples at which
/// a patch has no normal are skipped.
/// Source: tangent plane continuity; [KimChoi, fig. 11] shows a sufficient condition.
std::vector<BorderBreak> border_breaks(const Surface& surface);

/// The continuity of a surface or a part.
struct SurfaceContinuity {
    Continuity continuity;  ///< least continuity of all borders; G1 if there is none
    BorderBreak worst;      ///< worst break; its angle is 0 if there is no inner border
};

/// The continuity over all `border_breaks` of the surface.
SurfaceContinuity continuity(const Surface& surface);

/// The continuity of a part of several surfaces: inside each surface, and wherever two
/// sides meet, of two surfaces or of the same one.
///
/// Two sides of patches meet if their ends are the same two points, in either order, up
/// to 1e-6 of the part's size. Their parameters may run differently. A side that meets no
/// other is a border of the part. The angle is the change of the normal across the
/// border, up to 180 degrees where the part folds back. 17 samples of each side are
/// examined.
/// \throws DomainError if there are no surfaces.
SurfaceContinuity continuity(std::span<const Surface> surfaces);

}  // namespace endmill
