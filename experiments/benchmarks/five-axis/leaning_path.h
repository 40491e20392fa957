// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "endmill/path/tool_path.h"
#include "endmill/stock/height_stock.h"

// The paths of the benchmarks of five axes.
namespace endmill {

/// A full block of 100 by 100 by 50 mm, with its top at z = 0.
inline Block full_block()
{
    return {{0, 0, -50}, {100, 100, 0}};
}

/// Lines along x through `full_block`, forwards and backwards, all at one depth. Lead and
/// tilt of the tool change along the way, by up to 20 and 15 degrees.
struct LeaningPath {
    int moves;      ///< number
    double step;    ///< mm, way of a move
    double radius;  ///< mm, of the ball
    double depth;   ///< mm below the top of the block

    /// The path, a line for every row of the block.
    ToolPath path() const
    {
        constexpr double side = 100;
        constexpr double lead = 0.35;
        constexpr double tilt = 0.26;
        const int steps = static_cast<int>(std::lround(side / step));
        const double apart = side / (std::ceil(static_cast<double>(moves) / (steps + 1)));
        ToolPath made;
        for (int k = 0; k <= moves; ++k) {
            const int line = k / (steps + 1);
            const int along = k % (steps + 1);
            const double x = line % 2 == 0 ? along * step : side - along * step;
            const double y = (line + 0.5) * apart;
            const Vec3 axis = Vec3{std::tan(lead * std::sin(x / 12 + line)),
                                   std::tan(tilt * std::cos(x / 17 - y / 9)), 1}
                                  .normalized();
            const Vec3 centre{x, y, radius - depth};
            made.points.push_back({.pass = line,
                                   .point = along,
                                   .move = k == 0 ? Move::Plunge : Move::Cut,
                                   .location = {centre - radius * axis, axis}});
        }
        return made;
    }
};

}  // namespace endmill
