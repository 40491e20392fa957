// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/facet_groups.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "random.h"
#include "teapot.h"
#include "test_meshes.h"

namespace endmill {
namespace {

// Facets in random order, some of them without an area.
TriangleMesh shuffled(const TriangleMesh& mesh, int without_area)
{
    std::vector<Vec3> points{mesh.points().begin(), mesh.points().end()};
    std::vector<Triangle> triangles{mesh.triangles().begin(), mesh.triangles().end()};
    for (int k = 0; k < without_area; ++k)
        triangles.push_back({k, k, k + 1});
    test::Random random{4};
    for (std::size_t k = triangles.size(); k > 1; --k) {
        const auto other =
            static_cast<std::size_t>(random.uniform(0, static_cast<double>(k)));
        std::swap(triangles[k - 1], triangles[std::min(other, k - 1)]);
    }
    return {std::move(points), std::move(triangles)};
}

void expect_each_facet_once(const TriangleMesh& part)
{
    const PartFacets facets = part_facets(part);
    const FacetGroups groups = facet_groups(part, facets);
    std::vector<int> seen(part.triangles().size(), 0);
    ASSERT_EQ(groups.centroids.size(), groups.groups.size());
    for (std::size_t number = 0; number < groups.groups.size(); ++number) {
        const FacetGroup& group = groups.groups[number];
        const GroupCentroids& centroids = groups.centroids[number];
        ASSERT_GE(group.count, 1);
        ASSERT_LE(group.count, float_lanes);
        for (int lane = 0; lane < float_lanes; ++lane) {
            const std::int32_t facet = group.facet[lane];
            for (int k = 0; k < 3; ++k)
                EXPECT_EQ(groups.points[group.corner[k][lane]], part.corners(facet)[k]);
            if (lane < group.count) {
                ++seen[facet];
                EXPECT_EQ(Vec3(centroids.x[lane], centroids.y[lane], centroids.z[lane]),
                          facets.centroids[facet]);
            } else {
                EXPECT_EQ(facet, group.facet[group.count - 1]);
            }
        }
    }
    for (std::size_t facet = 0; facet < seen.size(); ++facet)
        EXPECT_EQ(seen[facet], facets.has_area(facet) ? 1 : 0);
}

TEST(FacetGroups, ContainEachFacetWithAnAreaOnce)
{
    expect_each_facet_once({});
    expect_each_facet_once(test::teapot());
    expect_each_facet_once(shuffled(test::torus_mesh(20, 12), 0));
    expect_each_facet_once(shuffled(test::flat_mesh(9, 7), 5));
    expect_each_facet_once(TriangleMesh{{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}}});
}

// The clusters follow the groups; their boxes and bits are those of their facets.
TEST(FacetGroups, AreEightToACluster)
{
    std::vector<Vec3> points = test::points_of(test::torus_mesh(20, 12));
    std::vector<Triangle> triangles = test::triangles_of(test::torus_mesh(20, 12));
    points.emplace_back(10, 0, 0);
    points.emplace_back(11, 0, 0);
    points.emplace_back(10.5, 1e-9, 0);  // the needle's normal is uncertain
    triangles.push_back({240, 241, 242});
    const TriangleMesh part{points, triangles};
    const FacetGroups groups = facet_groups(part, part_facets(part));
    ASSERT_EQ(groups.clusters.size(), 8U);
    ASSERT_EQ(groups.groups.size(), 61U);
    int ill_shaped = 0;
    for (std::size_t k = 0; k < groups.groups.size(); ++k) {
        const FacetCluster& cluster = groups.clusters[k / 8];
        for (int lane = 0; lane < groups.groups[k].count; ++lane) {
            const auto bit = k % 8 * 8 + lane;
            const std::int32_t facet = groups.groups[k].facet[lane];
            EXPECT_TRUE(cluster.facets >> bit & 1);
            ill_shaped += !(cluster.well_shaped >> bit & 1);
            if (!(cluster.well_shaped >> bit & 1)) {
                EXPECT_EQ(facet, 480);
            }
            for (const Vec3& corner : part.corners(facet))
                EXPECT_TRUE(((corner - cluster.centre).cwiseAbs().array() <=
                             cluster.half.array() + 1e-12)
                                .all());
        }
    }
    EXPECT_EQ(ill_shaped, 1);
    EXPECT_EQ(groups.clusters.back().facets, (std::uint64_t{1} << 33) - 1);
}

TEST(FacetGroups, TellWhichFacetsFaceADirection)
{
    const TriangleMesh part = test::torus_mesh(7, 4);
    const PartFacets facets = part_facets(part);
    const FacetGroups groups = facet_groups(part, facets);
    const Vec3 direction = Vec3{1, 2, -0.5}.normalized();
    const std::array<float, 3> limits{-0.7F, -0.1F, 0.9F};
    const auto above = facets_above(groups.normals, direction.cast<float>(), limits);
    for (std::size_t k = 0; k < 56; ++k) {
        const double cosine =
            facets.normals[groups.groups[k / 8].facet[k % 8]].dot(direction);
        for (int limit = 0; limit < 3; ++limit)
            EXPECT_EQ((above[limit] >> k & 1) != 0, cosine > limits[limit]);
    }
}

// A square has 2 a^2 facets. A group of eight covers 4 / a^2 of it, or slightly more.
TEST(FacetGroups, ProjectTheirCentroids)
{
    const TriangleMesh part = shuffled(test::torus_mesh(9, 5), 0);
    const FacetGroups groups = facet_groups(part, part_facets(part));
    Eigen::Matrix3d rows;
    rows << 0.01, 0.02, -0.03, 0.02, -0.01, 0.005, 0.001, 0.03, 0.02;
    const Vec3 centre{1, -2, 3};
    for (const GroupCentroids& centroids : groups.centroids) {
        const PlaceLanes places = projected(centroids, rows, centre);
        for (int lane = 0; lane < float_lanes; ++lane) {
            const Vec3 at{centroids.x[lane], centroids.y[lane], centroids.z[lane]};
            EXPECT_LT((places.place(lane).cast<double>() - rows * (at - centre)).norm(),
                      1e-7);
        }
    }
}

TEST(FacetGroups, ContainNeighbouringFacets)
{
    constexpr int a = 40;
    const TriangleMesh part = shuffled(test::flat_mesh(a, a), 0);
    const FacetGroups groups = facet_groups(part, part_facets(part));
    Eigen::AlignedBox3d whole;
    double sum = 0;
    for (const FacetGroup& group : groups.groups) {
        Eigen::AlignedBox3d box;
        for (int lane = 0; lane < float_lanes; ++lane)
            for (int k = 0; k < 3; ++k)
                box.extend(groups.points[group.corner[k][lane]]);
        whole.extend(box);
        sum += box.sizes().x() * box.sizes().y();
    }
    EXPECT_EQ(groups.groups.size(), std::size_t{a * a / 4});
    EXPECT_LT(sum, 3 * whole.sizes().x() * whole.sizes().y());
}

}  // namespace
}  // namespace endmill
