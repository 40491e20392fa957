// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "endmill/core/vec.h"
#include "endmill/machine/rotary_limits.h"

namespace endmill {

/// Why a first rotary axis was tried.
enum class RectangleOrigin {
    GreatCircle,       ///< all directions lie on one great circle through the tool axis
    GnomonicEdge,      ///< a meridian through two directions: the paper's E1
    OrthographicEdge,  ///< a parallel through two directions: E3
    Limit,             ///< a direction lies at a limit of the machine
    Search             ///< at no direction in particular
};

/// A rectangle between two meridians and two parallels about R1 that holds the tool axis and
/// given directions: what a machine of family A,B reaches. Source: [KangSuh, eq. (15)–(21)].
struct RectangleCandidate {
    Vec3 r1_axis;       ///< unit, perpendicular to the tool axis
    RotaryRange alpha;  ///< rad, about R1; holds 0
    RotaryRange beta;   ///< rad, about R2 = C x R1; holds 0, within [-pi / 2, pi / 2]
    RectangleOrigin origin;

    /// rad^2, the paper's F.
    double area() const { return (alpha.to - alpha.from) * (beta.to - beta.from); }

    /// rad, of both ranges.
    double sum() const { return (alpha.to - alpha.from) + (beta.to - beta.from); }
};

/// The rectangle about a given first rotary axis: alpha = atan2(-v . R2, v . C), beta =
/// asin(v . R1) with R2 = C x R1; alpha is 0 where v = +-R1. Its origin is `Search`.
/// Source: [KangSuh, eq. (17), (18)], in closed form.
/// \param tool_axis unit: C. \param r1_axis unit, perpendicular to it. \param directions unit.
RectangleCandidate rectangle_about(const Vec3& tool_axis, const Vec3& r1_axis,
                                   std::span<const Vec3> directions);

/// Whether a machine with `limits` of alpha (phi) and beta (theta) reaches the rectangle of a
/// rigid part, which can be turned by 180 degrees about the tool axis, so that both ranges
/// change their signs, but not mirrored.
bool fits_rigidly(const RectangleCandidate& rectangle, const RotaryLimits& limits);

}  // namespace endmill
