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

/// A tree of boxes over the facets of a part, for tests of cylinders. Each node halves
/// its facets at the median along the longest side of its box. It is a tree of its own,
/// because TriangleTree answers rays and distances only.
class FacetBoxes {
public:
    /// \param part facets in mm; it is not kept.
    explicit FacetBoxes(const TriangleMesh& part);

    /// Tests whether `meets(facet)` is true for a facet. Facets in a box for which
    /// `may_meet(low, high)` is false are skipped.
    template <typename MayMeet, typename Meets>
    bool any(const MayMeet& may_meet, const Meets& meets) const
    {
        // Each level halves the facets, so that the depth is below 64.
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
        std::int32_t begin;     // first of its facets in order_
        std::int32_t end;       // one beyond the last
        std::int32_t children;  // index of the first of two children; 0: a leaf
    };

    Node node_of(const TriangleMesh& part, std::int32_t begin, std::int32_t end) const;

    std::vector<std::int32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace endmill
