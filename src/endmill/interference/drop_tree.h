// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to interference
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include "endmill/cutter/cutter.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

class DropEntries;
struct DropEntry;

/// Triangles in the order of Hilbert's curve in plan, under a tree of nodes with four
/// children each, from which a search learns how high a cutter could come to rest on what
/// is below. Refers to the mesh, which must outlive it. Takes about 47 bytes a triangle,
/// and 10 more unless the cutter is a ball.
///
/// A node has a box in plan and a plane z = a + g . (x, y) that nothing in it is above. On
/// that plane alone the tip would rest at F = a + |g| (R - r) + r (n - 1) + g . (x, y), n =
/// sqrt(1 + g^2), touching at (x, y) + o, o = g / 2c, with
///     1 / 2c = (R - r) / |g| + r / n.
/// The cutter being convex, a point that lies a distance d from there in plan and not above
/// the plane lets the tip rest no higher than F - c d^2: on a sphere the chord to the
/// touching point is at least d long, and its end (chord)^2 n / 2r above the tangent plane
/// along the axis; on the rim of a disc likewise, the slope |g| times d^2 / 2(R - r) lower;
/// of both together the least for a given d is that with the sum of the inverses.
/// Source: derived here.
class DropTree {
public:
    /// Four nodes, in mm, about origin(). Numbers are rounded such that bounds by floats
    /// are none too low.
    struct Nodes {
        Eigen::Array4f low_x;
        Eigen::Array4f low_y;
        Eigen::Array4f high_x;
        Eigen::Array4f high_y;
        Eigen::Array4f height;  ///< F over the low corner of the box
        Eigen::Array4f offset_x;
        Eigen::Array4f offset_y;
        Eigen::Array4f fall;  ///< c, per mm
    };

    /// A straight move of the tip, in mm about the origin.
    struct FloatMove {
        Eigen::Array2f from;
        Eigen::Array2f to;
        float from_z;  ///< rounded down
        float to_z;
    };

    /// \throws DomainError if a coordinate of a point is above 1e9 mm, or the cutter's
    ///         radius is not within 1e-6 … 1e6 mm.
    DropTree(const TriangleMesh& mesh, const Cutter& cutter);

    const TriangleMesh& mesh() const { return *mesh_; }
    const Cutter& cutter() const { return cutter_; }
    const Vec3& origin() const { return origin_; }  ///< middle of the mesh, mm
    const Eigen::Vector2d& half_size() const
    {
        return half_;
    }  ///< of the mesh in plan, mm

    /// Bounds of the tip at place (x, y) over four nodes; minus infinity where they are
    /// out of reach. \param x, y floats, in mm about the origin.
    Eigen::Array4f tip_bounds(const Nodes& nodes, const Eigen::Array4f& tops, float x,
                              float y) const;

    /// Bounds of how far four nodes rise above the tip of a cutter that moves straight from
    /// place to place; minus infinity where they stay out of reach.
    Eigen::Array4f rise_bounds(const Nodes& nodes, const Eigen::Array4f& tops,
                               const FloatMove& move) const;

    /// The piece of a node's plane over its box, about the origin.
    struct Plane {
        Vec3 middle;
        Eigen::Vector2d half_size;
        Eigen::Vector2d slope;
        bool is_empty;  ///< nothing is there
    };
    Plane plane(const Nodes& nodes, Eigen::Index k) const;

    /// Shows `query` all triangles that may matter, the promising ones first. It has
    ///     Eigen::Array4f bounds(const Nodes&, const Eigen::Array4f& tops);
    ///     float limit();  // what is bounded below that does not matter
    ///     void look_at(std::size_t triangle);
    template <typename Query>
    void search(Query& query) const;

private:
    struct Level {
        std::vector<Nodes> nodes;
        std::vector<Eigen::Array4f> tops;  // greatest z in each node; none for a ball
    };
    struct Waiting {
        float bound;
        std::uint32_t node;
        std::int32_t level;
    };

    void build(DropEntries entries);
    void set_node(Level& level, std::size_t number, const DropEntry& whole) const;
    const Eigen::Array4f& tops_of(const Level& level, std::uint32_t node) const
    {
        return level.tops.empty() ? no_tops_ : level.tops[node];
    }

    const TriangleMesh* mesh_;
    Cutter cutter_;
    Vec3 origin_ = Vec3::Zero();
    Eigen::Vector2d half_ = Eigen::Vector2d::Zero();
    float reach_ = 0;  // R, rounded up by what floats lose
    Eigen::Array4f no_tops_;
    std::vector<std::uint32_t> order_;  // triangles, four to each of the lowest Nodes
    std::vector<Level> levels_;  // from the triangles upwards; the last has one Nodes
};

inline Eigen::Array4f DropTree::tip_bounds(const Nodes& nodes, const Eigen::Array4f& tops,
                                           float x, float y) const
{
    const auto outside = [](const Eigen::Array4f& low, const Eigen::Array4f& high,
                            const Eigen::Array4f& place) -> Eigen::Array4f {
        return (low - place).max(place - high).max(0.0F);
    };
    const Eigen::Array4f touched_x = nodes.offset_x + x;
    const Eigen::Array4f touched_y = nodes.offset_y + y;
    const Eigen::Array4f away_x = outside(nodes.low_x, nodes.high_x, touched_x);
    const Eigen::Array4f away_y = outside(nodes.low_y, nodes.high_y, touched_y);
    const Eigen::Array4f lift =
        2 * (nodes.offset_x * (x - nodes.low_x) + nodes.offset_y * (y - nodes.low_y)) -
        (away_x * away_x + away_y * away_y);
    const Eigen::Array4f all_x = Eigen::Array4f::Constant(x);
    const Eigen::Array4f all_y = Eigen::Array4f::Constant(y);
    const Eigen::Array4f gap_x = outside(nodes.low_x, nodes.high_x, all_x);
    const Eigen::Array4f gap_y = outside(nodes.low_y, nodes.high_y, all_y);
    const Eigen::Array4f bounds = (nodes.height + nodes.fall * lift).min(tops);
    return (gap_x * gap_x + gap_y * gap_y <= reach_ * reach_)
        .select(bounds, -std::numeric_limits<float>::infinity());
}

template <typename Query>
void DropTree::search(Query& query) const
{
    if (levels_.empty())
        return;
    // 2^33 pieces make 17 levels, each of which leaves three nodes to be visited.
    std::array<Waiting, 64> waiting;
    std::size_t count = 0;
    const auto top = static_cast<std::int32_t>(levels_.size()) - 1;
    waiting[count++] = {std::numeric_limits<float>::infinity(), 0, top};
    while (count > 0) {
        const Waiting next = waiting[--count];
        if (!(next.bound >= query.limit()))
            continue;
        if (next.level < 0) {
            query.look_at(order_[next.node]);
            continue;
        }
        const Level& level = levels_[next.level];
        const Eigen::Array4f bounds =
            query.bounds(level.nodes[next.node], tops_of(level, next.node));
        const float limit = query.limit();
        const std::size_t before = count;
        for (std::uint32_t k = 0; k < 4; ++k) {
            const float bound = bounds[k];
            if (!(bound >= limit))
                continue;
            std::size_t place = count++;
            for (; place > before && waiting[place - 1].bound > bound; --place)
                waiting[place] = waiting[place - 1];
            waiting[place] = {bound, next.node * 4 + k, next.level - 1};
        }
    }
}

}  // namespace endmill
