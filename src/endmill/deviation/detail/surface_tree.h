// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <deque>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "endmill/deviation/detail/once.h"
#include "endmill/deviation/detail/sampled_patch.h"
#include "endmill/mesh/triangle_tree.h"
#include "endmill/surface/detail/bend_bounds.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// A bounding volume hierarchy for the nearest place on surfaces. The surfaces are
/// approximated by triangles with corners on them.
///
/// It is separate from `TriangleTree`, which needs all triangles when it is built.
/// The triangles are made piece by piece, when a query comes near: most queries ask about
/// few places, and sampling the whole part finely would take longer than all queries. The
/// tree refers to the surfaces, which must outlive it. Queries may run on any number of
/// threads.
class SurfaceTree {
public:
    /// \param chord_tolerance greatest distance in mm between surfaces and triangles,
    ///        both ways.
    /// \throws LimitError if there may be more than `most_sampled_triangles`.
    SurfaceTree(std::span<const Surface> surfaces, double chord_tolerance);

    /// Returns the place of the triangles that is nearest to `place`, with the number of
    /// its piece in place of the triangle's number. Of equally near places that of the
    /// first piece counts.
    /// \param hint the piece of a query nearby; it makes the query faster and does not
    ///        change the result.
    /// \param within in mm; only nearer places count.
    /// \return nothing if no triangle is nearer than `within`.
    std::optional<NearestPoint> nearest(
        const Vec3& place, std::optional<std::size_t> hint,
        double within = std::numeric_limits<double>::infinity()) const;

    /// Error bound: the distance between surfaces and triangles, mm.
    double chord_error() const { return chord_error_; }

private:
    // The cells from (low_u, low_v) to (high_u, high_v) of the 2^level_u by 2^level_v
    // cells of a patch.
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
        // All corners of the cells, row by row.
        std::vector<Vec3> points() const;
    };
    struct Sample {
        Once make_once = {};
        std::optional<SampledPatch> patch = {};
    };
    struct Box {
        Vec3 low;
        Vec3 high;
        double squared_distance(const Vec3& place) const
        {
            return (low - place).cwiseMax(place - high).cwiseMax(0).squaredNorm();
        }
    };
    // Bounds of the second derivatives on equal parts of a patch.
    struct Bounds {
        Halvings halvings;
        std::span<const BendBounds> parts;

        // Those on the part in which the cells lie.
        const BendBounds& of(const Cells& cells) const;
    };
    void add_patch(const Cells& whole);
    void add(const Cells& cells, const Bounds& bounds);
    void add_upper_boxes();
    const SampledPatch& sample(std::size_t piece) const;
    void look_at(NearestSearch& search, std::size_t piece) const;
    void look_into(NearestSearch& search, std::size_t level, std::size_t number) const;

    std::vector<Cells> pieces_;
    mutable std::deque<Sample> samples_;  // one per piece
    std::vector<TangentDisc> discs_;      // around each piece
    // Levels of boxes: around each piece, then around every four boxes of the level
    // below, up to a single box.
    std::vector<std::vector<Box>> boxes_{1};
    double chord_error_ = 0;
};

}  // namespace endmill
