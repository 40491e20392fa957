// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <deque>
#include <limits>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "endmill/deviation/detail/sampled_sheet.h"
#include "endmill/mesh/triangle_tree.h"
#include "endmill/surface/detail/bend_bounds.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// Answers where surfaces are nearest, by triangles with corners on them. These are made
/// piece by piece, when a question comes near: most questions are about few places, and
/// all of a part finely sampled takes longer than all that is asked. Refers to the
/// surfaces, which must outlive it. May be asked by any number of threads.
class SampledPieces {
public:
    /// \param chord_tolerance in mm: no place of the surfaces is further from the
    /// triangles, nor one of the triangles from the surfaces.
    /// \throws LimitError if there might be more than `most_sampled_triangles`.
    SampledPieces(std::span<const Surface> surfaces, double chord_tolerance);

    /// The place of the triangles that is nearest to `place`; instead of the triangle's
    /// number that of its piece is given. Of equal ones in several pieces it is the first
    /// piece's. \param hint the piece of a question nearby: the answer comes sooner, and
    /// is the same. \param within in mm: only what is nearer is asked for.
    /// \return nothing if no triangle is so near.
    std::optional<NearestPoint> nearest(
        const Vec3& place, std::optional<std::size_t> hint,
        double within = std::numeric_limits<double>::infinity()) const;

    /// A bound on the distance between surfaces and triangles, mm.
    double chord_error() const { return chord_error_; }

private:
    // Cells (low_u, low_v) up to (high_u, high_v) of the 2^level_u by 2^level_v of a patch.
    struct Cells {
        const Surface* surface;
        int column;  // of the patch
        int row;
        int level_u;
        int level_v;
        int low_u = 0;
        int low_v = 0;
        int high_u = 1 << level_u;
        int high_v = 1 << level_v;

        Vec3 point(int u, int v) const;
    };
    struct Sample {
        std::once_flag is_made = {};
        std::optional<SampledSheet> sheet = {};
    };
    struct Box {
        Vec3 low;
        Vec3 high;
        double squared_distance(const Vec3& place) const
        {
            return (low - place).cwiseMax(place - high).cwiseMax(0).squaredNorm();
        }
    };
    void add(const Cells& cells, const BendBounds& bounds);
    void add_upper_boxes();
    const SampledSheet& sheet(std::size_t piece) const;
    void look_at(NearestSearch& search, std::size_t piece) const;
    void look_into(NearestSearch& search, std::size_t level, std::size_t number) const;

    std::vector<Cells> pieces_;
    mutable std::deque<Sample> samples_;  // one a piece
    std::vector<Slab> slabs_;             // around each
    // Around the pieces too, then around every few of these, and so on to a single one.
    std::vector<std::vector<Box>> boxes_{1};
    double chord_error_ = 0;
};

}  // namespace endmill
