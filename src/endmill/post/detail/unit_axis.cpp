// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/unit_axis.h"

#include <cmath>

namespace endmill {
namespace {

// Deviation of a length from 1 that the rounding of a written axis explains.
constexpr double rounding_of_doubles = 1e-12;

}  // namespace

std::optional<Vec3> unit_axis(const Vec3& axis)
{
    const double off = std::abs(axis.norm() - 1);
    if (off <= rounding_of_doubles)
        return axis;
    if (off <= axis_length_tolerance)
        return axis.normalized();
    return std::nullopt;
}

}  // namespace endmill
