// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/sweep_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "endmill/core/error.h"

// The tree is built top-down. The items are boxes around pieces of moves; each node
// splits its items at the median along the axis in which their low corners spread most.
// Nodes are stored in depth-first order, so that the first child follows its parent.

namespace endmill {
namespace {

// Items of a leaf; more than four make the leaves too large, fewer make the tree too
// deep.
constexpr std::size_t most_items_a_leaf = 4;
// A move longer than this many radii is split into pieces with a box each, because one
// box around a long oblique move is mostly empty.
constexpr double piece_radii = 4;
// Limit of the pieces of a move.
constexpr int most_pieces = 1000;

}  // namespace

SweepTree::SweepTree(std::span<const StraightSweep> sweeps) : sweeps_{sweeps}
{
    require(sweeps.size() < std::numeric_limits<std::uint32_t>::max() / 2,
            "SweepTree: need fewer than 2^31 moves");
    if (sweeps.empty())
        return;
    for (std::size_t i = sweeps.size(); i-- > 0;)
        if (const Cutter& cutter = sweeps[i].cutter(); std::ranges::none_of(
                roots_, [&](const Root& root) { return root.cutter == cutter; }))
            roots_.push_back({cutter, 0});
    std::vector<Item> items;
    for (Root& root : roots_) {
        items.clear();
        for (std::uint32_t i = 0; i < sweeps.size(); ++i)
            if (sweeps[i].cutter() == root.cutter)
                add_items(i, items);
        nodes_.reserve(nodes_.size() + items.size());
        items_.reserve(items_.size() + items.size());
        root.node = static_cast<std::uint32_t>(nodes_.size());
        build(items);
    }
}

// Adds the boxes of a move's pieces.
void SweepTree::add_items(std::uint32_t number, std::vector<Item>& items) const
{
    const StraightSweep& sweep = sweeps_[number];
    const double radius = sweep.cutter().radius();
    const int pieces =
        std::clamp(static_cast<int>(std::ceil(std::min<double>(
                       sweep.length() / (piece_radii * radius), most_pieces))),
                   1, most_pieces);
    const Vec3 lift{0, 0, sweep.cutter().corner_radius()};
    for (int k = 0; k < pieces; ++k) {
        Box box;
        for (const int end : {k, k + 1}) {
            const double share = end / double(pieces);
            const Vec3 at =
                lift + (end == pieces
                            ? sweep.to()
                            : Vec3{sweep.from() + share * (sweep.to() - sweep.from())});
            box.low = box.low.cwiseMin(at);
            box.high_x = std::max(box.high_x, at.x());
            box.high_y = std::max(box.high_y, at.y());
        }
        items.push_back({box, number});
    }
}

double SweepTree::least_corner_radius() const
{
    double least = roots_.empty() ? 0 : roots_.front().cutter.corner_radius();
    for (const Root& root : roots_)
        least = std::min(least, root.cutter.corner_radius());
    return least;
}

void SweepTree::build(std::span<Item> items)
{
    const std::size_t number = nodes_.size();
    Node node;
    Vec3 most = Vec3::Constant(-std::numeric_limits<double>::infinity());
    for (const Item& item : items) {
        node.low = node.low.cwiseMin(item.box.low);
        node.high_x = std::max(node.high_x, item.box.high_x);
        node.high_y = std::max(node.high_y, item.box.high_y);
        most = most.cwiseMax(item.box.low);
    }
    node.first = static_cast<std::uint32_t>(items_.size());
    node.count = 0;
    if (items.size() <= most_items_a_leaf) {
        node.count = static_cast<std::uint32_t>(items.size());
        for (const Item& item : items)
            items_.push_back(item.sweep);
        nodes_.push_back(node);
        return;
    }
    nodes_.push_back(node);
    int axis = 0;
    (most - node.low).maxCoeff(&axis);
    const auto middle = items.begin() + static_cast<std::ptrdiff_t>(items.size() / 2);
    std::nth_element(
        items.begin(), middle, items.end(), [axis](const Item& a, const Item& b) {
            return a.box.low[axis] != b.box.low[axis] ? a.box.low[axis] < b.box.low[axis]
                                                      : a.sweep < b.sweep;
        });
    build({items.begin(), middle});
    nodes_[number].first = static_cast<std::uint32_t>(nodes_.size());
    build({middle, items.end()});
}

}  // namespace endmill
