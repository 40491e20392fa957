// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "endmill/core/vec.h"
#include "endmill/cutter/cutter.h"

namespace endmill {

/// The part of a triangle that a cutter touches.
enum class TouchKind : std::uint8_t { Facet, Edge, Vertex };

/// Where a cutter comes to rest that is lowered along -z onto a triangle.
struct TriangleContact {
    double tip_z = -std::numeric_limits<double>::infinity();  ///< mm; that: no contact
    Vec3 point =
        Vec3::Zero();  ///< mm, where it touches; one of several if it does so in more
    TouchKind kind = TouchKind::Facet;
};

/// Lowers a cutter over (x, y) onto a triangle: its tip comes to rest at the greatest
/// q_z - h(rho) of the triangle's points q, rho <= R their distance from the axis and h
/// the cutter's profile, whichever way the triangle faces. That is a concave function of
/// q, so that its greatest value is at the touching point of the plane or, where that is
/// not in the triangle, on a side that has it on its far side.
///
/// The tip is right to 1e-9 mm, for coordinates within 1e4 mm and radii within 1e3 mm: also
/// at the cutter's rim, where the profile is vertical, on steep and on thin triangles,
/// which are done again with twice the digits. A triangle without area is its sides.
/// Source: derived here; the touching points are those of [JangKimJeong, eq. (3)].
class TriangleDrop {
public:
    explicit TriangleDrop(const Cutter& cutter);

    const Cutter& cutter() const { return cutter_; }

    /// \param corners, x, y in mm. \param least a contact below that, in mm, is of no
    ///        interest: any answer below it, also none, may stand for it.
    TriangleContact operator()(
        const std::array<Vec3, 3>& corners, double x, double y,
        double least = -std::numeric_limits<double>::infinity()) const;

private:
    Cutter cutter_;
};

}  // namespace endmill
