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
#include "endmill/path/tool_path.h"

namespace endmill {

/// What the cutter clears on the move to each point of `path`; on that to the first, what
/// it clears standing there, unless it comes by a rapid or a retract.
/// \throws GeometryError, with the point, if the axis of one is not +z.
std::vector<StraightSweep> path_sweeps(const ToolPath& path, const Cutter& cutter);

/// Finds the moves that may clear something near a place. Keeps a tree of boxes around
/// pieces of the moves, about 60 bytes a move, and refers to the sweeps, which must
/// outlive it.
class SweepTree {
public:
    explicit SweepTree(std::span<const StraightSweep> sweeps);

    std::span<const StraightSweep> sweeps() const { return sweeps_; }

    /// Whether all sweeps are of one cutter.
    bool is_of_one_cutter() const { return roots_.size() < 2; }

    /// Of all sweeps' cutters, mm; 0 if one has a sharp edge, or there is none.
    double least_corner_radius() const;

    /// Calls `visit(number of a sweep)` for the sweeps whose reference points (one corner
    /// radius above the tips) lie in boxes for which `may_matter(nearest)` holds, `nearest`
    /// being the box's point nearest to `place`, boxes being open above as the cutter is.
    /// Nearer boxes come first by and large, and `may_matter` is asked late, so that it
    /// may grow stricter on the way. A long move may be visited more than once. The order
    /// depends on the sweeps and the answers only.
    ///
    /// \param may_matter may also ask for the cutter of the box's sweeps, as a second argument;
    /// of several cutters that of the last sweep comes first, one after the other.
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

    // Around the reference points of pieces of moves, open above, as the cutter is.
    struct Box {
        Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
        double high_x = -std::numeric_limits<double>::infinity();
        double high_y = -std::numeric_limits<double>::infinity();
    };
    struct Node : Box {
        std::uint32_t first;  // item, or the second child; the first child follows
        std::uint32_t count;  // of items; 0 for an inner node
    };
    struct Root {  // of the sweeps of one cutter
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
