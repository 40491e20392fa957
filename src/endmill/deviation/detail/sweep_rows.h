// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "endmill/deviation/detail/ray_bounds.h"
#include "endmill/stock/detail/sweep_tree.h"

namespace endmill {

/// A sweep that may clear a point of some rays.
struct NearSweep {
    std::int32_t number;
    HalfSpace half;  ///< contains all that the sweep clears
};

/// Sweeps as a structure of arrays, so that the compiler tests several at once.
class SweepRows {
public:
    /// Takes the sweeps of the tree that may clear a point of the rays. These sweeps must
    /// outlive the rows.
    SweepRows(const SweepTree& tree, const RayBounds& rays);

    /// Returns the sweeps that may clear a point of these rays, mostly near ones first. A
    /// sweep may occur twice.
    std::vector<NearSweep> near(const RayBounds& rays) const;

    /// Returns the rows of these sweeps.
    SweepRows reduced(const RayBounds& rays) const;

    /// Pointers to the numbers of the sweeps.
    struct Columns {
        const double* x;   ///< mm, start of the move, one corner radius above the tip
        const double* y;   ///< mm
        const double* z;   ///< mm
        const double* dx;  ///< mm, the move
        const double* dy;  ///< mm
        const double* dz;  ///< mm
        const double* per_squared;    ///< 1 / length^2 of the move; 0 if the length is
        const double* per_level;      ///< the same, seen from above
        const double* flat_radius;    ///< mm
        const double* corner_radius;  ///< mm
    };

private:
    static constexpr std::size_t columns = 10;

    explicit SweepRows(std::span<const StraightSweep> sweeps) : sweeps_{sweeps} {}
    const double* column_begin(std::size_t column) const
    {
        return rows_.data() + column * numbers_.size();
    }
    void fill();
    Columns columns_from(std::size_t first) const;
    template <typename Visit>
    void visit_near(const RayBounds& rays, const Visit& visit) const;

    std::span<const StraightSweep> sweeps_;
    std::vector<std::int32_t> numbers_;
    std::vector<double> rows_;  // one column after the other
};

}  // namespace endmill
