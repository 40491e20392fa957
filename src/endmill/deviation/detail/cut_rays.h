// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "endmill/deviation/detail/cut_ray.h"
#include "endmill/deviation/detail/ray_bounds.h"
#include "endmill/deviation/detail/ray_rows.h"
#include "endmill/stock/detail/sweep_tree.h"

namespace endmill {

/// Neighbouring measuring rays of the part while the moves cut them.
///
/// This is the discrete vector method, with vectors along the part's normals: every move
/// shortens the rays that meet its swept volume. `cut_ray` defines the result for
/// one ray and one sweep; the thickness of a ray is the smallest over all sweeps.
/// Source: docs/methods/removal.md, section 2.
class CutRays {
public:
    /// \param rays 1 to most_tile_cells of them.
    /// \param lengths thickness of each ray before any move, mm.
    /// \throws DomainError for another number of rays or lengths.
    CutRays(std::span<const PartRay> rays, std::span<const double> lengths);

    /// Cuts the rays by every sweep of the tree that reaches them.
    void cut(const SweepTree& tree);

    /// Cuts the rays of several tiles by every sweep of the tree that reaches them. The
    /// result is that of each tile alone, within rounding; it is faster for neighbours.
    static void cut_together(std::span<CutRays* const> tiles, const SweepTree& tree);

    /// Cuts the rays by one sweep with this number.
    void cut(const StraightSweep& sweep, std::int32_t number);

    /// Returns the numbers of the sweeps that may clear a point of the remaining rays, or
    /// a point within `margin` mm above or beside them; each once, rising.
    std::vector<std::int32_t> near_sweeps(const SweepTree& tree, double margin) const;

    /// Returns the numbers of the sweeps that may gouge the part within `reach` mm of the
    /// rays' points; each once, rising.
    /// \param sag greatest distance of the part from the tangent planes at the rays'
    ///        points within the reach, mm.
    std::vector<std::int32_t> gouging_sweeps(const SweepTree& tree, double reach,
                                             double sag) const;

    /// Ray `k` after the cuts so far.
    CutRay operator[](int k) const;

    /// A cylinder and a cone that contain the remaining rays.
    const RayBounds& bounds() const { return bounds_; }

private:
    PartRay ray(std::size_t k) const;
    CutRays some() const;
    static CutRays middles(std::span<CutRays* const> tiles);
    std::size_t nearest_ray(const Vec3& place) const;
    std::vector<std::int32_t> makers() const;
    void cut_by(const SweepTree& tree, std::span<const std::int32_t> numbers);
    bool may_matter(const Cutter& cutter, const Vec3& nearest, double margin,
                    double length) const;
    bool may_reach(const HalfSpace& half, const Cutter& cutter, double margin,
                   RayRows::Row& short_by) const;
    void cut(const StraightSweep& sweep, std::int32_t number, const HalfSpace& half);
    void shorten_each(const StraightSweep& sweep, std::int32_t number,
                      const RayRows::Row& short_by);

    RayBounds bounds_;
    RayRows rows_;
};

}  // namespace endmill
