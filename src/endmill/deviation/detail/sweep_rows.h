// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "endmill/deviation/detail/ray_bounds.h"
#include "endmill/stock/detail/sweep_tree.h"

namespace endmill {

/// Sweeps as a structure of arrays, so that the compiler tests several at once.
class SweepRows {
public:
    /// Takes the sweeps of the tree that may clear a point of the rays.
    SweepRows(const SweepTree& tree, const RayBounds& rays);

    /// Returns the numbers of the sweeps that may clear a point of these rays, mostly
    /// near ones first. A number may occur twice.
    std::vector<std::int32_t> near(const RayBounds& rays) const;

private:
    void add(const StraightSweep& sweep, std::int32_t number);

    // x, y, z: reference point at the start of the move, one corner radius above the tip,
    // mm. dx, dy, dz: the move, mm. per_squared, per_level: 1 over the squared length of
    // the move in space and seen from above; 0 if the length is.
    struct Rows {
        std::vector<double> x, y, z, dx, dy, dz, per_squared, per_level, flat_radius,
            corner_radius;
    };
    Rows rows_;
    std::vector<std::int32_t> numbers_;
};

}  // namespace endmill
