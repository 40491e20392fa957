// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
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

    /// Number of sweeps that are tested at a time.
    static constexpr std::size_t block_size = 64;

    /// Numbers of up to `block_size` sweeps.
    struct Block {
        using Column = std::array<double, block_size>;  ///< one number per sweep

        std::array<std::int32_t, block_size> number;  ///< of the sweep
        Column x;              ///< mm, start of the move, one corner radius above the tip
        Column y;              ///< mm
        Column z;              ///< mm
        Column dx;             ///< mm, the move
        Column dy;             ///< mm
        Column dz;             ///< mm
        Column per_squared;    ///< 1 / length^2 of the move; 0 if the length is
        Column per_level;      ///< the same, seen from above
        Column flat_radius;    ///< mm
        Column corner_radius;  ///< mm

        /// Sets the numbers at place `k` to those of a sweep.
        void set(std::size_t k, std::int32_t its_number, const StraightSweep& sweep);
        /// Copies the numbers at place `from` of another block to place `k`.
        void copy(std::size_t k, const Block& other, std::size_t from);
    };

private:
    explicit SweepRows(std::span<const StraightSweep> sweeps) : sweeps_{sweeps} {}
    void add(const Block& block, std::size_t k);
    void add_near(const RayBounds& rays, const Block& block, std::size_t count);
    template <typename Visit>
    void visit_near(const RayBounds& rays, const Visit& visit) const;

    std::span<const StraightSweep> sweeps_;
    std::size_t count_ = 0;
    std::vector<Block> blocks_;  // all full but the last
};

}  // namespace endmill
