// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "endmill/path/tool_path.h"

namespace endmill {

/// A zig-zag path over a wavy plate of 200 x 120 mm with every kind of move: a plunge
/// from the safe height, `passes` passes of `points` points with links between them, a
/// retract, and a rapid back. Points clear of the part have no contact.
inline ToolPath wavy_path(int passes, int points)
{
    const Vec3 axis{0, 0, 1};
    const double safe_height = 60;
    ToolPath path;
    for (int pass = 0; pass < passes; ++pass)
        for (int point = 0; point < points; ++point) {
            const double along = static_cast<double>(point) / (points - 1);
            const double u = pass % 2 == 0 ? along : 1 - along;
            const double v = static_cast<double>(pass) / passes;
            const Vec3 contact{200 * u, 120 * v, 20 * std::sin(9 * u) * std::cos(5 * v)};
            const Vec3 normal = Vec3{0.1 * std::cos(9 * u), 0.1 * v, 1}.normalized();
            const Vec3 tip = contact + 7.5 * (normal - axis);
            const Move move = point > 0  ? Move::Cut
                              : pass > 0 ? Move::Link
                                         : Move::Plunge;
            path.points.push_back({pass,
                                   point,
                                   move,
                                   0,
                                   {tip, axis},
                                   SurfaceContact{u, v, {contact, normal}}});
        }
    Vec3 above = path.points.back().location.tip;
    above.z() = safe_height;
    path.points.push_back({passes, 0, Move::Retract, 0, {above, axis}});
    path.points.push_back({passes, 1, Move::Rapid, 0, {{0, 0, safe_height}, axis}});
    return path;
}

}  // namespace endmill
