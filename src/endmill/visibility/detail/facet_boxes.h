// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// A tree of boxes over the facets of a part: each node halves its facets at the middle one
/// along the longest side of the box around them.
class FacetBoxes {
public:
    /// `part` must outlive it.
    explicit FacetBoxes(const TriangleMesh& part);

    /// Whether `meets(facet)` holds for a facet all of whose boxes pass `may_meet(low, high)`.
    template <typename MayMeet, typename Meets>
    bool any(const MayMeet& may_meet, const Meets& meets) const
    {
        // The tree halves: it is no deeper than a count of facets has bits.
        std::array<std::int32_t, 64> waiting;
        std::size_t count = 0;
        if (!nodes_.empty())
            waiting[count++] = 0;
        while (count > 0) {
            const Node& node = nodes_[waiting[--count]];
            if (!may_meet(node.low, node.high))
                continue;
            if (node.children != 0) {
                waiting[count++] = node.children;
                waiting[count++] = node.children + 1;
                continue;
            }
            for (std::int32_t k = node.begin; k < node.end; ++k)
                if (meets(static_cast<std::size_t>(order_[k])))
                    return true;
        }
        return false;
    }

private:
    struct Node {
        Vec3 low;
        Vec3 high;
        std::int32_t begin;     // of its facets in the order
        std::int32_t end;       // of its facets in the order
        std::int32_t children;  // the first of two, 0 if there are none
    };

    Node node_of(const TriangleMesh& part, std::int32_t begin, std::int32_t end) const;

    std::vector<std::int32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace endmill
