// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/facet_groups.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <span>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/core/detail/widest_registers.h"
#include "endmill/core/parallel.h"

namespace endmill {
namespace {

// Smaller sets of facets are ordered by a single thread.
constexpr std::size_t facets_of_a_thread = 1 << 14;

// Orders facets so that those of a group are neighbours. A set of facets is halved along
// the longest side of the box around its centroids, at a whole number of clusters or, in
// a cluster, of groups. Each half is ordered in the same way.
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
    const std::size_t whole = facets.size() > FacetCluster::size
                                  ? std::size_t{FacetCluster::size}
                                  : std::size_t{float_lanes};
    const std::size_t half = (facets.size() / 2 + whole - 1) / whole * whole;
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

// Least area of a well-shaped facet, in squares of its longest side: part_facets bounds
// the error of a normal by 1e-15 times the inverse.
constexpr double least_area_share = 1e-8;
// mm^2; smaller areas may have lost digits by underflow.
constexpr double least_area = 1e-280;

bool is_well_shaped(const std::array<Vec3, 3>& corners)
{
    const auto& [a, b, c] = corners;
    const double longest =
        std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    const double area = (b - a).cross(c - a).stableNorm() / 2;
    return area > least_area_share * longest && area > least_area && std::isfinite(area);
}

// Groups and clusters of facets in their order; the points are numbered as they occur.
class Grouping {
public:
    Grouping(const TriangleMesh& part, const PartFacets& facets)
        : part_{part},
          facets_{facets},
          number_(part.points().size(), -1)
    {
    }

    void add_cluster(std::span<const std::int32_t> facets)
    {
        FacetCluster cluster;
        Eigen::AlignedBox3d box;
        for (std::size_t k = 0; k < facets.size(); ++k) {
            const std::array<Vec3, 3> corners = part_.corners(facets[k]);
            for (const Vec3& corner : corners)
                box.extend(corner);
            cluster.facets |= std::uint64_t{1} << k;
            cluster.well_shaped |= std::uint64_t{is_well_shaped(corners)} << k;
        }
        cluster.centre = box.min() / 2 + box.max() / 2;
        cluster.half = box.max() / 2 - box.min() / 2;
        groups.clusters.push_back(cluster);
        for (std::size_t first = 0; first < facets.size(); first += float_lanes)
            add_group(facets.subspan(
                first, std::min<std::size_t>(float_lanes, facets.size() - first)));
    }

    FacetGroups groups;

private:
    void add_group(std::span<const std::int32_t> facets)
    {
        FacetGroup& group = groups.groups.emplace_back();
        GroupNormals& normals = groups.normals.emplace_back();
        GroupCentroids& centroids = groups.centroids.emplace_back();
        group.count = static_cast<int>(facets.size());
        for (int lane = 0; lane < float_lanes; ++lane) {
            const std::int32_t facet = facets[std::min(lane, group.count - 1)];
            group.facet[lane] = facet;
            for (int k = 0; k < 3; ++k)
                group.corner[k][lane] = numbered(part_.triangles()[facet][k]);
            if (lane >= group.count)
                continue;
            const Vec3& normal = facets_.normals[facet];
            normals.x[lane] = static_cast<float>(normal.x());
            normals.y[lane] = static_cast<float>(normal.y());
            normals.z[lane] = static_cast<float>(normal.z());
            centroids.x[lane] = facets_.centroids[facet].x();
            centroids.y[lane] = facets_.centroids[facet].y();
            centroids.z[lane] = facets_.centroids[facet].z();
        }
    }

    std::int32_t numbered(std::int32_t point)
    {
        if (number_[point] < 0) {
            number_[point] = static_cast<std::int32_t>(groups.points.size());
            groups.points.push_back(part_.points()[point]);
        }
        return number_[point];
    }

    const TriangleMesh& part_;
    const PartFacets& facets_;
    std::vector<std::int32_t> number_;
};

}  // namespace

ENDMILL_WIDEST_REGISTERS
std::array<std::uint64_t, 3> facets_above(std::span<const GroupNormals> groups,
                                          const Eigen::Vector3f& direction,
                                          const std::array<float, 3>& limits)
{
    std::array<std::uint64_t, 3> above{};
    const WideFloats x = direction.x();
    const WideFloats y = direction.y();
    const WideFloats z = direction.z();
    for (std::size_t k = 0; k < groups.size(); ++k) {
        const GroupNormals& normals = groups[k];
        const WideFloats cosine = WideFloats{normals.x.data()} * x +
                                  WideFloats{normals.y.data()} * y +
                                  WideFloats{normals.z.data()} * z;
        for (int limit = 0; limit < 3; ++limit)
            above[limit] |= std::uint64_t{(cosine > WideFloats{limits[limit]}).bits()}
                            << (float_lanes * k);
    }
    return above;
}

ENDMILL_WIDEST_REGISTERS
PlaceLanes projected(const GroupCentroids& centroids, const Eigen::Matrix3d& rows,
                     const Vec3& centre)
{
    using Doubles = double __attribute__((vector_size(float_lanes * sizeof(double))));
    using Floats = float __attribute__((vector_size(float_lanes * sizeof(float))));
    Doubles x;
    Doubles y;
    Doubles z;
    std::memcpy(&x, centroids.x.data(), sizeof x);
    std::memcpy(&y, centroids.y.data(), sizeof y);
    std::memcpy(&z, centroids.z.data(), sizeof z);
    x -= centre.x();
    y -= centre.y();
    z -= centre.z();
    PlaceLanes places;
    for (int axis = 0; axis < 3; ++axis) {
        const Doubles sum = rows(axis, 0) * x + rows(axis, 1) * y + rows(axis, 2) * z;
        const auto rounded = __builtin_convertvector(sum, Floats);
        std::memcpy(places.at[axis].data(), &rounded, sizeof rounded);
    }
    return places;
}

FacetGroups facet_groups(const TriangleMesh& part, const PartFacets& facets)
{
    std::vector<std::int32_t> order;
    order.reserve(part.triangles().size());
    for (std::size_t facet = 0; facet < part.triangles().size(); ++facet)
        if (facets.has_area(facet))
            order.push_back(static_cast<std::int32_t>(facet));
    order_by_place(order, facets.centroids);

    Grouping grouping{part, facets};
    for (std::size_t first = 0; first < order.size(); first += FacetCluster::size)
        grouping.add_cluster(std::span{order}.subspan(
            first, std::min<std::size_t>(FacetCluster::size, order.size() - first)));
    return std::move(grouping.groups);
}

}  // namespace endmill
