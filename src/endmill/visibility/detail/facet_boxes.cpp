// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/facet_boxes.h"

#include <numeric>

namespace endmill {
namespace {

// Facets of a leaf. Testing a few facets is cheaper than testing boxes around them.
constexpr std::int32_t leaf_facets = 4;

}  // namespace

FacetBoxes::Node FacetBoxes::node_of(const TriangleMesh& part, std::int32_t begin,
                                     std::int32_t end) const
{
    Node node{part.corners(order_[begin])[0], part.corners(order_[begin])[0], begin, end,
              0};
    for (std::int32_t k = begin; k < end; ++k)
        for (const Vec3& corner : part.corners(order_[k])) {
            node.low = node.low.cwiseMin(corner);
            node.high = node.high.cwiseMax(corner);
        }
    return node;
}

FacetBoxes::FacetBoxes(const TriangleMesh& part) : order_(part.triangles().size())
{
    std::iota(order_.begin(), order_.end(), 0);
    if (order_.empty())
        return;
    nodes_.push_back(node_of(part, 0, static_cast<std::int32_t>(order_.size())));
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
        const Node node = nodes_[k];
        if (node.end - node.begin <= leaf_facets)
            continue;
        int axis = 0;
        (node.high - node.low).maxCoeff(&axis);
        const auto place = [&](std::int32_t facet) {
            const auto corners = part.corners(facet);
            return corners[0][axis] + corners[1][axis] + corners[2][axis];
        };
        const std::int32_t middle = node.begin + (node.end - node.begin) / 2;
        std::nth_element(order_.begin() + node.begin, order_.begin() + middle,
                         order_.begin() + node.end, [&](std::int32_t a, std::int32_t b) {
                             return place(a) < place(b) ||
                                    (place(a) == place(b) && a < b);
                         });
        nodes_[k].children = static_cast<std::int32_t>(nodes_.size());
        nodes_.push_back(node_of(part, node.begin, middle));
        nodes_.push_back(node_of(part, middle, node.end));
    }
}

}  // namespace endmill
