// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/machine/rotary_limits.h"

namespace endmill {

/// Where the axis of a set of tool directions may be: C in C,A, R1 in A,B.
struct AxisPlace {
    RotaryFamily family = RotaryFamily::CA;
    Vec3 axis = Vec3::UnitZ();  ///< unit
    double radius = 0;          ///< rad, in [0, pi / 2): the axis is at most this far off

    /// Cells are left out that lie farther off than this, and `radius`: C,A: from the pole, in
    /// the window and opposite; A,B: from the circle of latitude 0, to either side. rad.
    std::array<double, 2> reach = {4, 4};
};

/// A cell as it counts on one side of the set, or a part of the azimuths that it may have.
struct SeenCell {
    double begin;        ///< azimuth in [0, 2 pi), rad
    double end;          ///< rad, at least `begin`
    double level;        ///< C,A: polar angle; A,B: latitude, to its side; rad, >= 0
    std::uint32_t cell;  ///< its number in what was given
    std::uint8_t side;   ///< 0 or 1; C,A: each cell is seen on both, half a turn apart
};

/// The cells about an axis. Whatever axis within the radius is the true one, a cell's true level
/// is at most the radius off, and its true azimuth lies in one of its parts, once the true
/// axis is carried to the given one along their great circle.
struct AxisView {
    std::vector<SeenCell> swept;  ///< by `begin`; equal ones by cell, then side
    std::vector<SeenCell> free;   ///< those that may have any azimuth
};

/// The cells with these centres, which are unit vectors. A cell at angle p from the axis or its
/// opposite may have any azimuth where sin p <= sin(radius) (at radius 0: where sin p is below
/// 1e-12, less than which no machine resolves), else one within asin(sin(radius) / sin p);
/// long intervals are cut into parts of at most 3 radii. Azimuths are exact to 1e-15 / sin p.
AxisView axis_view(const AxisPlace& place, std::span<const Vec3> centres);

/// A unit vector at right angles to `axis`, from which `axis_view` measures azimuths, towards
/// axis x this.
Vec3 azimuth_zero(const Vec3& axis);

}  // namespace endmill
