// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/unit_axis.h"

#include <cmath>

#include "endmill/core/tolerance.h"

namespace endmill {
std::optional<Vec3> unit_axis(const Vec3& axis)
{
    const double off = std::abs(axis.norm() - 1);
    if (off <= unit_vector_rounding)
        return axis;
    if (off <= axis_length_tolerance)
        return axis.normalized();
    return std::nullopt;
}

}  // namespace endmill
