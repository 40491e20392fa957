// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "endmill/deviation/detail/cut_ray.h"
#include "endmill/deviation/detail/ray_bundle.h"
#include "endmill/deviation/detail/ray_rows.h"
#include "endmill/stock/detail/sweep_tree.h"

namespace endmill {

/// Rays of the part that lie near each other, and what the moves leave of each.
/// Source: "mowing the lawn" of the field: every move shortens the rays that meet the
/// region which it clears.
///
/// What is left of a ray is the least t at which a region that clears some point of it
/// outside the part (t >= 0) is entered: a region that ends below the part's surface has
/// taken something on another side of the part, whose own rays tell it.
class MownRays {
public:
    /// \param rays at most most_tile_cells. \param lengths what each has before any move.
    MownRays(std::span<const PartRay> rays, std::span<const double> lengths);

    /// Shortens the rays by every sweep of the tree that reaches them.
    void mow(const SweepTree& tree);

    /// Shortens the rays of several by every sweep of the tree that reaches them: as each
    /// by itself, but for rounding. Sooner for those that lie side by side.
    static void mow_together(std::span<MownRays* const> tiles, const SweepTree& tree);

    /// Shortens them by one sweep.
    void mow(const StraightSweep& sweep, std::int32_t number);

    /// Numbers of the sweeps that may clear something of the rays as they are now, or
    /// within `margin` mm above what is left or beside; each once, rising.
    std::vector<std::int32_t> near_sweeps(const SweepTree& tree, double margin) const;

    /// Numbers of the sweeps that may clear the part itself within `reach` mm of the rays'
    /// points, where it lies no more than `sag` mm over or under the planes square to the
    /// rays; each once, rising.
    std::vector<std::int32_t> sweeps_beneath(const SweepTree& tree, double reach,
                                             double sag) const;

    MownRay operator[](int k) const;

    /// What holds the rays as they are now.
    const RayBundle& bundle() const { return bundle_; }

private:
    PartRay ray(std::size_t k) const;
    static MownRays some(std::span<MownRays* const> tiles, int of_each);
    std::vector<std::int32_t> makers(int first, int count) const;
    void mow_by(const SweepTree& tree, std::span<const std::int32_t> numbers);
    bool may_matter(const Cutter& cutter, const Vec3& nearest, double margin,
                    double length) const;
    bool may_reach(const StraightSweep& sweep, double margin,
                   RayRows::Row& short_by) const;
    void shorten_each(const StraightSweep& sweep, std::int32_t number,
                      const RayRows::Row& short_by);

    RayBundle bundle_;
    RayRows rows_;
};

}  // namespace endmill
