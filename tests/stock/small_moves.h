// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "endmill/cutter/straight_sweep.h"
#include "endmill/stock/detail/tile_heights.h"
#include "random.h"

// A tile and moves about it.
namespace endmill::test {

struct SmallMove {
    Vec3 from;
    Vec3 to;

    SweptMove swept() const { return swept_move(from, to); }
};

/// A tile 0.8 mm wide at (-0.4, -0.4).
inline TilePlace small_tile()
{
    return tile_place({.low_x = -0.4,
                       .low_y = -0.4,
                       .pitch = 0.1,
                       .columns = 8,
                       .rows = 8,
                       .bottom_z = -100},
                      0, 0);
}

/// Moves that are short and long, level, steep, vertical and without length, near the
/// tile and beside it.
inline std::vector<SmallMove> small_moves(unsigned seed, int count)
{
    Random random{seed};
    std::vector<SmallMove> moves;
    for (int k = 0; k < count; ++k) {
        const double reach = k % 2 == 0 ? 0.5 : 20;
        const Vec3 from{random.uniform(-7, 7), random.uniform(-7, 7),
                        random.uniform(-3, 3)};
        Vec3 way{random.uniform(-reach, reach), random.uniform(-reach, reach),
                 random.uniform(-reach, reach)};
        if (k % 5 == 0)
            way.z() = 0;
        if (k % 7 == 0)
            way.x() = way.y() = 0;
        if (k % 35 == 0)
            way.setZero();
        if (k % 11 == 0)
            way.y() = 0;
        moves.push_back({from, from + way});
    }
    return moves;
}

/// Whether `z` is the height of the sweep within 1e-12 at (x, y), or at a place 1e-13
/// away, because the slope is unbounded at the cutter's rim.
inline bool is_height(const StraightSweep& sweep, double x, double y, double z)
{
    constexpr double near = 1e-13;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const double dx : {-near, 0.0, near})
        for (const double dy : {-near, 0.0, near}) {
            const double height = sweep.height(x + dx, y + dy);
            low = std::min(low, height);
            high = std::max(high, height);
        }
    return z >= low - 1e-12 && z <= high + 1e-12;
}

}  // namespace endmill::test
