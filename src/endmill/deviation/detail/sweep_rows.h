// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "endmill/deviation/detail/ray_bundle.h"
#include "endmill/stock/detail/sweep_tree.h"

namespace endmill {

/// Sweeps side by side, so that the compiler looks at several at a time.
class SweepRows {
public:
    /// Those of the tree that may clear something of the rays.
    SweepRows(const SweepTree& tree, const RayBundle& rays);

    /// Those that may clear something of these rays, near ones first by and large. One may
    /// be there twice.
    std::vector<std::int32_t> near(const RayBundle& rays) const;

private:
    void add(const StraightSweep& sweep, std::int32_t number);

    // Reference points at the starts, one corner radius above the tips, and moves, in mm;
    // per the squared length of the move, and of what it is seen from above: 0 if that is.
    struct Rows {
        std::vector<double> x, y, z, dx, dy, dz, per_squared, per_level, flat_radius,
            corner_radius;
    };
    Rows rows_;
    std::vector<std::int32_t> numbers_;
};

}  // namespace endmill
