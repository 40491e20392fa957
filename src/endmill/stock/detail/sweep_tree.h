// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "endmill/cutter/straight_sweep.h"

namespace endmill {

/// A bounding volume hierarchy over the moves of a path. It finds the moves that may
/// clear material near a place. There is one tree per cutter; its boxes hold pieces of
/// moves. The tree takes about 60 bytes per move and refers to the sweeps, which must
/// outlive it.
///
/// It is separate from `TriangleTree` because its boxes hold moves and are open above, and
/// because the caller rejects boxes by a bound of its own.
class SweepTree {
public:
    /// \throws DomainError for 2^31 sweeps or more.
    explicit SweepTree(std::span<const StraightSweep> sweeps);

    std::span<const StraightSweep> sweeps() const { return sweeps_; }  ///< as given

    /// Whether all sweeps have the same cutter.
    bool is_of_one_cutter() const { return roots_.size() < 2; }

    /// Smallest corner radius of all cutters in mm; 0 if a cutter has a sharp edge or
    /// there is no sweep.
    double least_corner_radius() const;

    /// Calls `visit(number)` for every sweep with a piece in a box that passes
    /// `may_matter`.
    ///
    /// A box holds the reference points (one corner radius above the tips) of pieces of
    /// moves and, like the cutter, is open above. `may_matter` receives the point of the
    /// box that is nearest to `place`. Nearer boxes mostly come first, and each box is
    /// tested only when its turn comes, so `may_matter` may become stricter during the
    /// traversal. A long move may be visited more than once. The order depends on the
    /// sweeps and on the answers of `may_matter` only.
    ///
    /// \param place in mm.
    /// \param may_matter called as `may_matter(nearest)` or, if it takes two arguments,
    ///        as `may_matter(nearest, cutter)` with the cutter of the box. With several
    ///        cutters, that of the last sweep comes first.
    /// \param visit called with the number of a sweep.
    template <typename MayMatter, typename Visit>
    void visit(const Vec3& place, const MayMatter& may_matter, const Visit& visit) const
    {
        for (const Root& root : roots_)
            visit_below(
                root.node, place,
                [&](const Vec3& nearest) {
                    if constexpr (std::is_invocable_v<MayMatter, const Vec3&,
                                                      const Cutter&>)
                        return may_matter(nearest, root.cutter);
                    else
                        return may_matter(nearest);
                },
                visit);
    }

private:
    template <typename MayMatter, typename Visit>
    void visit_below(std::uint32_t root, const Vec3& place, const MayMatter& may_matter,
                     const Visit& visit) const
    {
        std::array<std::uint32_t, 128> stack;
        std::size_t depth = 0;
        stack[depth++] = root;
        while (depth > 0) {
            const std::uint32_t number = stack[--depth];
            const Node& node = nodes_[number];
            if (!may_matter(nearest(node, place)))
                continue;
            if (node.count > 0) {
                for (std::uint32_t k = 0; k < node.count; ++k)
                    visit(std::size_t{items_[node.first + k]});
                continue;
            }
            const std::uint32_t children[] = {number + 1, node.first};
            const double distances[] = {
                (nearest(nodes_[children[0]], place) - place).squaredNorm(),
                (nearest(nodes_[children[1]], place) - place).squaredNorm()};
            const std::size_t nearer = distances[0] <= distances[1] ? 0 : 1;
            stack[depth++] = children[1 - nearer];
            stack[depth++] = children[nearer];
        }
    }

    // A box around the reference points of pieces of moves; open above, like the cutter.
    struct Box {
        Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
        double high_x = -std::numeric_limits<double>::infinity();
        double high_y = -std::numeric_limits<double>::infinity();
    };
    struct Node : Box {
        std::uint32_t
            // First item of a leaf, or the second child (the first child follows the
            // node)
            first;
        std::uint32_t count;  // number of items; 0 for an inner node
    };
    // The tree of the sweeps of one cutter.
    struct Root {
        Cutter cutter;
        std::uint32_t node;
    };
    struct Item {
        Box box;
        std::uint32_t sweep;
    };

    static Vec3 nearest(const Node& node, const Vec3& place)
    {
        return {std::clamp(place.x(), node.low.x(), node.high_x),
                std::clamp(place.y(), node.low.y(), node.high_y),
                std::max(place.z(), node.low.z())};
    }
    void build(std::span<Item> items);
    void add_items(std::uint32_t sweep, std::vector<Item>& items) const;

    std::span<const StraightSweep> sweeps_;
    std::vector<Root> roots_;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> items_;  // numbers of sweeps
};

}  // namespace endmill
