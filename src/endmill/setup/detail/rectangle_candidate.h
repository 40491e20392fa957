// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "endmill/core/vec.h"
#include "endmill/machine/axis_limits.h"

namespace endmill {

/// The reason for which a position of R1 was tried.
enum class RectangleOrigin {
    GreatCircle,       ///< all directions lie on one great circle through the tool axis
    GnomonicEdge,      ///< a meridian passes through two directions: the paper's E1
    OrthographicEdge,  ///< a parallel passes through two directions: the paper's E3
    Limit,             ///< a direction lies at a limit of the machine
    Search             ///< a search or the caller chose the position
};

/// A rectangle of a machine of family A,B: the directions between two meridians and two
/// parallels about R1. It contains the tool axis and given directions. Source: [KangSuh,
/// eq. (15)–(21)].
struct RectangleCandidate {
    Vec3 r1_axis;       ///< unit, perpendicular to the tool axis
    RotaryRange alpha;  ///< rad, about R1; contains 0
    RotaryRange beta;   ///< rad, about R2 = C x R1; contains 0, within [-pi / 2, pi / 2]
    RectangleOrigin origin;

    /// Area in rad^2, the paper's F.
    double area() const { return (alpha.to - alpha.from) * (beta.to - beta.from); }

    /// Sum of both ranges in rad.
    double sum() const { return (alpha.to - alpha.from) + (beta.to - beta.from); }
};

/// The least rectangle about a given R1: alpha = atan2(-v . R2, v . C) and beta = asin(v
/// . R1) with R2 = C x R1. alpha is 0 for v = +-R1. The origin of the result is `Search`.
/// Source: [KangSuh, eq. (17), (18)], in the closed form of
/// docs/methods/five-axis-setup.md, section 3.
/// \param tool_axis unit: C. \param r1_axis unit, perpendicular to it. \param directions
///         unit.
RectangleCandidate rectangle_about(const Vec3& tool_axis, const Vec3& r1_axis,
                                   std::span<const Vec3> directions);

/// Tests whether a rectangle fits limits of alpha (phi) and beta (theta) with their
/// signs. The part may be turned by 180 degrees about the tool axis, which negates both
/// ranges; it may not be mirrored.
bool fits_rigidly(const RectangleCandidate& rectangle, const RotaryLimits& limits);

}  // namespace endmill
