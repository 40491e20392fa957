// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/tip_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace endmill {
namespace {

// Most tips of a node that is not halved.
constexpr unsigned leaf_tips = 8;

}  // namespace

// The nearest groups found so far.
struct TipTree::Search {
    Vec3 place;
    std::size_t count;
    std::vector<Neighbour> found;  // the nearest first

    double farthest() const
    {
        return found.size() < count ? std::numeric_limits<double>::infinity()
                                    : found.back().distance_squared;
    }

    double distance_squared(const Node& node) const
    {
        return (place - place.cwiseMax(node.low).cwiseMin(node.high)).squaredNorm();
    }

    void offer(const Neighbour& tip, std::span<const unsigned> groups)
    {
        if (!(tip.distance_squared < farthest()))
            return;
        const auto same = std::ranges::find_if(found, [&](const Neighbour& other) {
            return groups[other.tip] == groups[tip.tip];
        });
        if (same != found.end()) {
            if (same->distance_squared <= tip.distance_squared)
                return;
            found.erase(same);
        } else if (found.size() == count) {
            found.pop_back();
        }
        found.insert(std::ranges::upper_bound(found, tip.distance_squared, {},
                                              &Neighbour::distance_squared),
                     tip);
    }
};

TipTree::TipTree(std::span<const Vec3> places, std::span<const unsigned> groups)
    : places_{places},
      groups_{groups},
      order_(places.size()),
      leaf_(places.size()),
      is_removed_(places.size())
{
    std::iota(order_.begin(), order_.end(), 0U);
    if (!places.empty())
        build(0, static_cast<unsigned>(places.size()), none);
}

unsigned TipTree::build(unsigned begin, unsigned end, unsigned parent)
{
    Vec3 low = places_[order_[begin]];
    Vec3 high = low;
    for (unsigned k = begin; k < end; ++k) {
        low = low.cwiseMin(places_[order_[k]]);
        high = high.cwiseMax(places_[order_[k]]);
    }
    const auto number = static_cast<unsigned>(nodes_.size());
    nodes_.push_back({low, high, begin, end, parent, none, none, end - begin});
    if (end - begin <= leaf_tips) {
        for (unsigned k = begin; k < end; ++k)
            leaf_[order_[k]] = number;
        return number;
    }
    int axis = 0;
    (high - low).maxCoeff(&axis);
    const unsigned middle = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle,
                     order_.begin() + end, [&](unsigned a, unsigned b) {
                         const double at_a = places_[a][axis];
                         const double at_b = places_[b][axis];
                         return at_a != at_b ? at_a < at_b : a < b;
                     });
    const unsigned lower = build(begin, middle, number);
    const unsigned upper = build(middle, end, number);
    nodes_[number].lower = lower;
    nodes_[number].upper = upper;
    return number;
}

void TipTree::remove(unsigned tip)
{
    if (is_removed_[tip])
        return;
    is_removed_[tip] = true;
    for (unsigned node = leaf_[tip]; node != none; node = nodes_[node].parent)
        --nodes_[node].tips;
}

std::vector<TipTree::Neighbour> TipTree::nearest(const Vec3& place,
                                                 std::size_t count) const
{
    Search found{place, count, {}};
    found.found.reserve(count + 1);
    if (count > 0 && !nodes_.empty() && nodes_.front().tips > 0)
        search(found, 0);
    return std::move(found.found);
}

void TipTree::search(Search& search, unsigned number) const
{
    const Node& node = nodes_[number];
    if (node.lower == none) {
        for (unsigned k = node.begin; k < node.end; ++k)
            if (const unsigned tip = order_[k]; !is_removed_[tip])
                search.offer({(places_[tip] - search.place).squaredNorm(), tip}, groups_);
        return;
    }
    const bool lower_first = search.distance_squared(nodes_[node.lower]) <=
                             search.distance_squared(nodes_[node.upper]);
    for (const unsigned half :
         {lower_first ? node.lower : node.upper, lower_first ? node.upper : node.lower})
        if (nodes_[half].tips > 0 &&
            search.distance_squared(nodes_[half]) < search.farthest())
            this->search(search, half);
}

}  // namespace endmill
