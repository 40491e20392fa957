// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// How smoothly two patches meet.
enum class Continuity {
    None,  ///< a gap
    G0,    ///< they share their border
    G1,    ///< and its normals
};

/// "none", "G0" or "G1".
std::string_view continuity_name(Continuity continuity);

/// What a border between two patches is like at its worst place.
struct BorderBreak {
    SurfacePoint at;  ///< on the border
    Vec3 point;       ///< mm
    Angle normals;    ///< between the normals of the two patches
    double gap_mm;    ///< between their points at the same parameters
    Continuity continuity;
    std::size_t surface = 0;  ///< which of several, from 0
};

/// What a gap in mm and an angle between normals amount to, on a part of `size` mm.
Continuity continuity_of(double gap_mm, Angle normals, double size);

/// Whether `one` is the worse of two breaks: less continuous, or else of a greater gap or
/// angle.
bool is_worse(const BorderBreak& one, const BorderBreak& other);

/// The worst break of every inner border: first those across u, then those across v. A
/// border counts as G1 where the normals are less than 1e-6 rad apart, as G0 where the
/// gap is below 1e-9 of the surface's diagonal; 17 samples each, ends included. Samples
/// at which a patch has no normal are passed over.
/// Source: general tangent continuity; [KimChoi, fig. 11] shows a sufficient condition.
std::vector<BorderBreak> border_breaks(const Surface& surface);

/// The surface as a whole: the least continuity of its borders and the worst break.
struct SurfaceContinuity {
    Continuity continuity;  ///< G1 if there is no inner border
    BorderBreak worst;      ///< at an angle of 0 if there is no inner border
};

/// Continuity over all of `border_breaks`.
SurfaceContinuity continuity(const Surface& surface);

/// Continuity of a part of several surfaces: within each as `continuity` says, and where
/// sides of two surfaces (or of one) meet. Two sides of patches meet if their ends are
/// the same two points to 1e-6 of the part's size, in either order; their parameters may
/// run differently. A side that meets no other is a border of the part. The angle is that
/// by which the part turns across the border, 180 degrees where it folds back. What 17
/// samples a side show is held to the limits of `border_breaks`.
///
/// `worst.surface` counts from 0. \throws DomainError if there are no surfaces.
SurfaceContinuity continuity(std::span<const Surface> surfaces);

}  // namespace endmill
