// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/swept_move.h"

#include <algorithm>
#include <cmath>

namespace endmill {

SweptMove swept_move(const Vec3& from, const Vec3& to)
{
    const double dx = to.x() - from.x();
    const double dy = to.y() - from.y();
    const double length = std::hypot(dx, dy);
    if (length == 0)
        return {.x = from.x(),
                .y = from.y(),
                .z = std::min(from.z(), to.z()),
                .rise = 0,
                .length = 0,
                .slope = 0,
                .direction_x = 1,
                .direction_y = 0};
    const double rise = to.z() - from.z();
    return {.x = from.x(),
            .y = from.y(),
            .z = from.z(),
            .rise = rise,
            .length = length,
            .slope = rise / length,
            .direction_x = dx / length,
            .direction_y = dy / length};
}

}  // namespace endmill
