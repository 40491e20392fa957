// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/machine/axis_limits.h"

namespace endmill {

/// A disc of axes: C in C,A, R1 in A,B.
struct AxisPlace {
    RotaryFamily family = RotaryFamily::CA;
    Vec3 axis = Vec3::UnitZ();  ///< unit: centre of the disc
    double radius = 0;  ///< rad, in [0, pi / 2): the true axis is at most this far off

    /// Largest levels, rad; cells beyond reach + radius are left out. C,A: polar angles
    /// in the window and opposite to it. A,B: latitudes to either side.
    std::array<double, 2> reach = {4, 4};
};

/// A cell on one side of the range of directions, with an interval of azimuths that it
/// may have.
struct SeenCell {
    double begin;        ///< azimuth in [0, 2 pi), rad
    double end;          ///< rad, at least `begin`
    double level;        ///< C,A: polar angle; A,B: magnitude of the latitude; rad, >= 0
    std::uint32_t cell;  ///< index of its centre
    std::uint8_t side;   ///< 0 or 1; C,A: a cell appears on both sides, half a turn apart
};

/// The cells as seen from the axes of a disc. For every axis of the disc, the level of a
/// cell differs from the stored level by at most the radius, and its azimuth lies in one
/// of the stored intervals. Azimuths are compared after the axis is moved to the centre
/// of the disc along their great circle.
struct AxisView {
    std::vector<SeenCell> swept;  ///< sorted by `begin`, then cell, then side
    std::vector<SeenCell> free;   ///< cells that may have any azimuth
};

/// Computes the view of cells. A cell at the angle p from the axis or its opposite may
/// have any azimuth if sin p <= sin(radius), or if sin p is below 1e-12, which no machine
/// resolves. Else its interval reaches asin(sin(radius) / sin p) to either side.
/// Intervals longer than 3 radii are cut into parts. Azimuths are accurate to 1e-15 / sin
/// p.
/// \param place disc of axes. \param centres unit.
/// Source: paper/notes/whole-cones.md, section 4.
AxisView axis_view(const AxisPlace& place, std::span<const Vec3> centres);

/// The direction of azimuth 0 in `axis_view`: a unit vector perpendicular to `axis`.
/// Azimuths increase towards axis x azimuth_zero(axis).
Vec3 azimuth_zero(const Vec3& axis);

}  // namespace endmill
