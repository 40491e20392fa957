// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/facet_groups.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "endmill/core/parallel.h"

namespace endmill {
namespace {

// Smaller sets of facets are ordered by a single thread.
constexpr std::size_t facets_of_a_thread = 1 << 14;

// Orders facets so that those of a group are neighbours. A set of facets is halved along
// the longest side of the box around its centroids, at a whole number of groups, and each
// half is ordered in the same way.
void order_by_place(std::span<std::int32_t> facets, const std::vector<Vec3>& centroids)
{
    if (facets.size() <= float_lanes)
        return;
    Vec3 low = centroids[facets[0]];
    Vec3 high = low;
    for (const std::int32_t facet : facets) {
        low = low.cwiseMin(centroids[facet]);
        high = high.cwiseMax(centroids[facet]);
    }
    int axis = 0;
    (high - low).maxCoeff(&axis);
    const std::size_t half =
        (facets.size() / 2 + float_lanes - 1) / float_lanes * float_lanes;
    const auto middle = facets.begin() + static_cast<std::ptrdiff_t>(half);
    std::nth_element(facets.begin(), middle, facets.end(),
                     [&](std::int32_t a, std::int32_t b) {
                         const double of_a = centroids[a][axis];
                         const double of_b = centroids[b][axis];
                         return of_a < of_b || (of_a == of_b && a < b);
                     });
    const std::array halves{facets.first(half), facets.subspan(half)};
    if (facets.size() < facets_of_a_thread) {
        for (const auto& each : halves)
            order_by_place(each, centroids);
        return;
    }
    parallel_for(2, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            order_by_place(halves[k], centroids);
    });
}

}  // namespace

FacetGroups facet_groups(const TriangleMesh& part, const PartFacets& facets)
{
    std::vector<std::int32_t> order;
    order.reserve(part.triangles().size());
    for (std::size_t facet = 0; facet < part.triangles().size(); ++facet)
        if (facets.has_area(facet))
            order.push_back(static_cast<std::int32_t>(facet));
    order_by_place(order, facets.centroids);

    FacetGroups groups;
    groups.centroids.reserve(order.size());
    for (const std::int32_t facet : order)
        groups.centroids.push_back(facets.centroids[facet]);
    std::vector<std::int32_t> number(part.points().size(), -1);
    const auto numbered = [&](std::int32_t point) {
        if (number[point] < 0) {
            number[point] = static_cast<std::int32_t>(groups.points.size());
            groups.points.push_back(part.points()[point]);
        }
        return number[point];
    };
    for (std::size_t first = 0; first < order.size(); first += float_lanes) {
        FacetGroup& group = groups.groups.emplace_back();
        group.count =
            static_cast<int>(std::min<std::size_t>(float_lanes, order.size() - first));
        for (int lane = 0; lane < float_lanes; ++lane) {
            group.facet[lane] = order[first + std::min(lane, group.count - 1)];
            for (int k = 0; k < 3; ++k)
                group.corner[k][lane] = numbered(part.triangles()[group.facet[lane]][k]);
        }
    }
    return groups;
}

}  // namespace endmill
