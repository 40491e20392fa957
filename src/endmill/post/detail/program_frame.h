// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/core/vec.h"

namespace endmill {

/// The coordinates of a program under the offsets of an interpreter: a programmed point p
/// is at R (p + axis_offset) + system_offset in the machine, where R turns about Z.
struct ProgramFrame {
    Vec3 system_offset = Vec3::Zero();  ///< mm, of G54 to G59.3
    Vec3 axis_offset = Vec3::Zero();    ///< mm, of G92
    double rotation_degrees = 0;        ///< of G10 L2 R, about Z

    bool operator==(const ProgramFrame&) const = default;
};

/// The coordinates in `to` of the point that is `point` in `from`. Equal frames give the
/// same doubles; otherwise the error is below 1e-15 of the coordinates and offsets.
Vec3 moved_to_frame(const Vec3& point, const ProgramFrame& from, const ProgramFrame& to);

}  // namespace endmill
