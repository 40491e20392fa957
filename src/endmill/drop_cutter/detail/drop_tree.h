// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include "endmill/core/detail/lanes.h"
#include "endmill/cutter/cutter.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

class DropEntries;
struct DropEntry;

/// The largest float that is not above `value`.
inline float rounded_down(double value)
{
    const auto rounded = static_cast<float>(value);
    return rounded <= value
               ? rounded
               : std::nextafter(rounded, -std::numeric_limits<float>::infinity());
}

/// A search tree for the drop cutter: the triangles of a mesh in the order of the Hilbert
/// curve in plan, under nodes with eight children each. A node has a bound of the height
/// at which a cutter can come to rest on its triangles. Takes about 41 bytes per
/// triangle, and 5 more unless the cutter is a ball. It is a tuned kernel beside the
/// library's other box trees: eight children are tested in one register, and a node's
/// plane follows a slope more closely than a box.
///
/// A node has a box in plan and a plane z = a + g . (x, y) above all its points. On that
/// plane alone the tip would rest at F = a + |g| (R - r) + r (n - 1) + g . (x, y) with n
/// = sqrt(1 + g^2). It would touch the plane at (x, y) + o, where o = g / 2c and
///
///     1 / 2c = (R - r) / |g| + r / n.
///
/// Because the cutter is convex, a point below the plane at a distance d in plan from the
/// touching point lets the tip rest at most at F - c d^2:
/// 1. On a sphere the chord to the touching point is at least d long. Its end lies
///    (chord)^2 n / 2r above the tangent plane, measured along the axis.
/// 2. On the rim of a disc the tip rests lower by |g| d^2 / 2(R - r), in the same way.
/// 3. For both together, the smallest value for a given d is obtained by adding the
///    inverses.
/// This derivation is our own.
class DropTree {
public:
    /// Eight nodes, in mm relative to origin(). The numbers are rounded such that bounds
    /// computed in floats are never too low.
    struct Nodes {
        FloatLanes low_x;     ///< box in plan
        FloatLanes low_y;     ///< box in plan
        FloatLanes high_x;    ///< box in plan
        FloatLanes high_y;    ///< box in plan
        FloatLanes height;    ///< F over the low corner of the box
        FloatLanes offset_x;  ///< o, mm
        FloatLanes offset_y;  ///< o, mm
        FloatLanes fall;      ///< c, per mm
    };

    /// A straight move of the tip, in mm relative to the origin.
    struct FloatMove {
        Eigen::Array2f from;  ///< x and y at its start
        Eigen::Array2f to;    ///< x and y at its end
        float from_z;         ///< rounded down
        float to_z;           ///< rounded down
    };

    /// \param mesh the triangles; it must outlive this object.
    /// \param cutter the cutter.
    /// \throws DomainError if a coordinate exceeds 1e9 mm or the cutter's radius is not
    ///     within 1e-6 … 1e6 mm.
    DropTree(const TriangleMesh& mesh, const Cutter& cutter);

    /// The mesh.
    const TriangleMesh& mesh() const { return *mesh_; }
    /// The cutter.
    const Cutter& cutter() const { return cutter_; }
    const Vec3& origin() const { return origin_; }  ///< middle of the mesh, mm
    /// Half the size of the mesh in plan, mm.
    const Eigen::Vector2d& half_size() const { return half_; }

    /// Upper bounds of the tip over the position (x, y) for eight nodes; minus infinity
    /// for nodes out of reach.
    /// \param nodes the nodes.
    /// \param tops largest z of each node.
    /// \param x mm, relative to the origin.
    /// \param y mm, relative to the origin.
    FloatLanes tip_bounds(const Nodes& nodes, const FloatLanes& tops, float x,
                          float y) const;

    /// Upper bounds of the rise of eight nodes above the tip of a cutter on a straight
    /// move; minus infinity for nodes out of reach.
    /// \param nodes the nodes.
    /// \param tops largest z of each node.
    /// \param move the move.
    FloatLanes rise_bounds(const Nodes& nodes, const FloatLanes& tops,
                           const FloatMove& move) const;

    /// The part of a node's plane over its box, relative to the origin.
    struct Plane {
        Vec3 middle;                ///< mm
        Eigen::Vector2d half_size;  ///< mm
        Eigen::Vector2d slope;      ///< mm per mm
        bool is_empty;              ///< the node has no points
    };
    /// The plane of node `k` of eight.
    Plane plane(const Nodes& nodes, Eigen::Index k) const;

    /// Shows `query` all triangles that may matter, the most promising first. A query has
    ///
    ///     FloatLanes bounds(const Nodes&, const FloatLanes& tops);  // of eight nodes
    ///     float limit();  // nodes with a lower bound do not matter
    ///     void look_at(std::size_t triangle);
    template <typename Query>
    void search(Query& query) const;

private:
    struct Level {
        std::vector<Nodes> nodes;
        std::vector<FloatLanes> tops;  // largest z in each node; empty for a ball
    };
    // A node or a triangle that waits to be visited, with its bound. Both are packed into
    // one word, which is written and read at once.
    class Waiting {
    public:
        Waiting() = default;  // for the array of WaitingNodes
        // `node` is the number of a Nodes on its level, or of an entry of order_.
        Waiting(float bound, std::uint32_t node)
            : word_{std::uint64_t{std::bit_cast<std::uint32_t>(bound)} << 32U | node}
        {
        }
        // The bound of the node.
        float bound() const
        {
            return std::bit_cast<float>(static_cast<std::uint32_t>(word_ >> 32U));
        }
        // Its number.
        std::uint32_t node() const { return static_cast<std::uint32_t>(word_); }

    private:
        std::uint64_t word_;
    };
    // 2^33 pieces make 11 levels. At most seven nodes of each level wait.
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
    float reach_ = 0;  // R plus the rounding error of floats
    FloatLanes no_tops_;
    std::vector<std::uint32_t> order_;  // triangles, eight for each of the lowest Nodes
    // from the triangles upwards; the last level has one Nodes
    std::vector<Level> levels_;
};

// Evaluates min(F - c d^2, top) for eight nodes at once. F is linear in the place, so
// that it follows from its value over the low corner of the box; d is the distance of the
// touching point from the box. Nodes whose box is beyond the cutter's radius are out of
// reach.
[[gnu::always_inline]] inline FloatLanes DropTree::tip_bounds(const Nodes& nodes,
                                                              const FloatLanes& tops,
                                                              float x, float y) const
{
    const WideFloats low_x{nodes.low_x};
    const WideFloats low_y{nodes.low_y};
    const WideFloats high_x{nodes.high_x};
    const WideFloats high_y{nodes.high_y};
    const WideFloats offset_x{nodes.offset_x};
    const WideFloats offset_y{nodes.offset_y};
    const auto outside = [](const WideFloats& low, const WideFloats& high,
                            const WideFloats& place) {
        return larger(larger(low - place, place - high), WideFloats{0.0F});
    };
    const WideFloats away_x = outside(low_x, high_x, offset_x + WideFloats{x});
    const WideFloats away_y = outside(low_y, high_y, offset_y + WideFloats{y});
    const WideFloats gap_x = outside(low_x, high_x, WideFloats{x});
    const WideFloats gap_y = outside(low_y, high_y, WideFloats{y});
    const WideFloats lift = WideFloats{2.0F} * (offset_x * (WideFloats{x} - low_x) +
                                                offset_y * (WideFloats{y} - low_y)) -
                            (away_x * away_x + away_y * away_y);
    const WideFloats bounds = smaller(
        WideFloats{nodes.height} + WideFloats{nodes.fall} * lift, WideFloats{tops});
    return kept_up_to(reach_ * reach_, (gap_x * gap_x + gap_y * gap_y).lanes(),
                      bounds.lanes());
}

// Inserts a node among those that wait from `first` on, which are sorted with the highest
// bound last.
inline void DropTree::put(const Waiting& node, std::size_t first, WaitingNodes& waiting)
{
    std::size_t place = waiting.count++;
    for (; place > first && waiting.nodes[place - 1].bound() > node.bound(); --place)
        waiting.nodes[place] = waiting.nodes[place - 1];
    waiting.nodes[place] = node;
}

// Depth-first search with the best child first:
// 1. The bounds of the eight children of a node are computed at once.
// 2. Children whose bound reaches the query's limit are put on the stack, the highest
//    last.
// 3. On the lowest level the children are triangles, which the query looks at
//    immediately.
// 4. The limit grows while triangles are found, so that nodes on the stack are compared
//    with it again when they are taken off.
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
