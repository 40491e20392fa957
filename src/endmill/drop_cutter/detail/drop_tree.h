// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include "endmill/core/detail/float_lanes.h"
#include "endmill/cutter/cutter.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

class DropEntries;
struct DropEntry;

/// Triangles in the order of Hilbert's curve in plan, under a tree of nodes with eight
/// children each, from which a search learns how high a cutter could come to rest on what
/// is below. Refers to the mesh, which must outlive it. Takes about 41 bytes a triangle,
/// and 5 more unless the cutter is a ball.
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
    /// Eight nodes, in mm, about origin(). Numbers are rounded such that bounds by floats
    /// are none too low.
    struct Nodes {
        FloatLanes low_x;
        FloatLanes low_y;
        FloatLanes high_x;
        FloatLanes high_y;
        FloatLanes height;  ///< F over the low corner of the box
        FloatLanes offset_x;
        FloatLanes offset_y;
        FloatLanes fall;  ///< c, per mm
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

    /// Bounds of the tip at place (x, y) over eight nodes; minus infinity where they are
    /// out of reach. \param x, y floats, in mm about the origin.
    FloatLanes tip_bounds(const Nodes& nodes, const FloatLanes& tops, float x,
                          float y) const;

    /// Bounds of how far eight nodes rise above the tip of a cutter that moves straight from
    /// place to place; minus infinity where they stay out of reach.
    FloatLanes rise_bounds(const Nodes& nodes, const FloatLanes& tops,
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
    ///     FloatLanes bounds(const Nodes&, const FloatLanes& tops);
    ///     float limit();  // what is bounded below that does not matter
    ///     void look_at(std::size_t triangle);
    template <typename Query>
    void search(Query& query) const;

private:
    struct Level {
        std::vector<Nodes> nodes;
        std::vector<FloatLanes> tops;  // greatest z in each node; none for a ball
    };
    // A node that waits, or a triangle; in one word, which is written and read at once.
    class Waiting {
    public:
        Waiting() = default;
        Waiting(float bound, std::uint32_t node)
            : word_{std::uint64_t{std::bit_cast<std::uint32_t>(bound)} << 32U | node}
        {
        }
        float bound() const
        {
            return std::bit_cast<float>(static_cast<std::uint32_t>(word_ >> 32U));
        }
        std::uint32_t node() const { return static_cast<std::uint32_t>(word_); }

    private:
        std::uint64_t word_;
    };
    // 2^33 pieces make 11 levels, each of which leaves seven nodes to be visited.
    struct WaitingNodes {
        std::array<Waiting, 80> nodes;
        std::array<std::int32_t, 80> levels;
        std::size_t count = 0;
    };
    static void put(const Waiting& node, std::size_t first, WaitingNodes& waiting);
    void build(DropEntries entries);
    void set_node(Level& level, std::size_t number, const DropEntry& whole) const;
    const FloatLanes& tops_of(const Level& level, std::uint32_t node) const
    {
        return level.tops.empty() ? no_tops_ : level.tops[node];
    }

    const TriangleMesh* mesh_;
    Cutter cutter_;
    Vec3 origin_ = Vec3::Zero();
    Eigen::Vector2d half_ = Eigen::Vector2d::Zero();
    float reach_ = 0;  // R, rounded up by what floats lose
    FloatLanes no_tops_;
    std::vector<std::uint32_t> order_;  // triangles, eight to each of the lowest Nodes
    std::vector<Level> levels_;  // from the triangles upwards; the last has one Nodes
};

[[gnu::always_inline]] inline FloatLanes DropTree::tip_bounds(const Nodes& nodes,
                                                              const FloatLanes& tops,
                                                              float x, float y) const
{
    const WideLanes low_x{nodes.low_x};
    const WideLanes low_y{nodes.low_y};
    const WideLanes high_x{nodes.high_x};
    const WideLanes high_y{nodes.high_y};
    const WideLanes offset_x{nodes.offset_x};
    const WideLanes offset_y{nodes.offset_y};
    const auto outside = [](const WideLanes& low, const WideLanes& high,
                            const WideLanes& place) {
        return larger(larger(low - place, place - high), WideLanes{0});
    };
    const WideLanes away_x = outside(low_x, high_x, offset_x + WideLanes{x});
    const WideLanes away_y = outside(low_y, high_y, offset_y + WideLanes{y});
    const WideLanes gap_x = outside(low_x, high_x, WideLanes{x});
    const WideLanes gap_y = outside(low_y, high_y, WideLanes{y});
    const WideLanes lift = WideLanes{2} * (offset_x * (WideLanes{x} - low_x) +
                                           offset_y * (WideLanes{y} - low_y)) -
                           (away_x * away_x + away_y * away_y);
    const WideLanes bounds =
        smaller(WideLanes{nodes.height} + WideLanes{nodes.fall} * lift, WideLanes{tops});
    return kept_up_to(reach_ * reach_, (gap_x * gap_x + gap_y * gap_y).lanes(),
                      bounds.lanes());
}

// What stands above `first` among those that wait, the highest last.
inline void DropTree::put(const Waiting& node, std::size_t first, WaitingNodes& waiting)
{
    std::size_t place = waiting.count++;
    for (; place > first && waiting.nodes[place - 1].bound() > node.bound(); --place)
        waiting.nodes[place] = waiting.nodes[place - 1];
    waiting.nodes[place] = node;
}

template <typename Query>
[[gnu::always_inline]] inline void DropTree::search(Query& query) const
{
    if (levels_.empty())
        return;
    WaitingNodes waiting;
    Waiting next{std::numeric_limits<float>::infinity(), 0};
    auto number = static_cast<std::int32_t>(levels_.size()) - 1;
    while (true) {
        const Level& level = levels_[number];
        const FloatLanes bounds =
            query.bounds(level.nodes[next.node()], tops_of(level, next.node()));
        const std::size_t before = waiting.count;
        for (unsigned lanes = lanes_not_below(query.limit(), bounds); lanes != 0;
             lanes &= lanes - 1) {
            const auto k = static_cast<std::uint32_t>(std::countr_zero(lanes));
            waiting.levels[waiting.count] = number - 1;
            put({bounds[k], next.node() * float_lanes + k}, before, waiting);
        }
        if (number == 0)
            for (; waiting.count > before; --waiting.count)
                if (const Waiting& triangle = waiting.nodes[waiting.count - 1];
                    triangle.bound() >= query.limit())
                    query.look_at(order_[triangle.node()]);
        do {
            if (waiting.count == 0)
                return;
            next = waiting.nodes[--waiting.count];
        } while (!(next.bound() >= query.limit()));
        number = waiting.levels[waiting.count];
    }
}

}  // namespace endmill
