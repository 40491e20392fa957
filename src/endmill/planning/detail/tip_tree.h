// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "endmill/core/vec.h"

namespace endmill {

/// A k-d tree of tool tips in groups. It finds the nearest groups, and tips can be removed
/// from it. A search takes about log(n) steps for n tips, unless most of the nearest tips
/// are in one group. `PointTree` of module mesh has neither groups nor removal.
class TipTree {
public:
    /// A tip that a search finds.
    struct Neighbour {
        double distance_squared;  ///< mm^2
        unsigned tip;             ///< its number
    };

    /// \param places mm, at most 2^31, finite.
    /// \param groups number of the group of each tip. Both must outlive the tree.
    TipTree(std::span<const Vec3> places, std::span<const unsigned> groups);

    /// Removes tip `tip` from later searches, unless it is removed already.
    void remove(unsigned tip);

    /// The nearest tips of the `count` nearest groups, one of each group, the nearest
    /// first; fewer if there are not so many groups. Of equally near tips it may return
    /// any, but always the same one.
    std::vector<Neighbour> nearest(const Vec3& place, std::size_t count) const;

private:
    static constexpr unsigned none = static_cast<unsigned>(-1);
    struct Node {
        Vec3 low;  // box around the tips
        Vec3 high;
        unsigned begin;  // range in order_
        unsigned end;
        unsigned parent;
        unsigned lower;  // its halves, or none
        unsigned upper;
        unsigned tips;  // that are not removed
    };
    struct Search;

    unsigned build(unsigned begin, unsigned end, unsigned parent);
    void search(Search& search, unsigned node) const;

    std::span<const Vec3> places_;
    std::span<const unsigned> groups_;
    std::vector<Node> nodes_;
    std::vector<unsigned> order_;   // tips, so that a node has a range
    std::vector<unsigned> leaf_;    // node of each tip
    std::vector<char> is_removed_;  // by tip
};

}  // namespace endmill
