// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/program_frame.h"

#include <cmath>
#include <numbers>

namespace endmill {
namespace {

Vec3 turned_about_z(const Vec3& vector, double degrees)
{
    if (degrees == 0)
        return vector;
    constexpr double half_turn_degrees = 180;
    const double angle = degrees * std::numbers::pi / half_turn_degrees;
    return {std::cos(angle) * vector.x() - std::sin(angle) * vector.y(),
            std::sin(angle) * vector.x() + std::cos(angle) * vector.y(), vector.z()};
}

}  // namespace

Vec3 moved_to_frame(const Vec3& point, const ProgramFrame& from, const ProgramFrame& to)
{
    if (from == to)
        return point;
    const Vec3 in_machine =
        turned_about_z(point + from.axis_offset, from.rotation_degrees) +
        from.system_offset;
    return turned_about_z(in_machine - to.system_offset, -to.rotation_degrees) -
           to.axis_offset;
}

}  // namespace endmill
