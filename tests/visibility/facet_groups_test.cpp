// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/facet_groups.h"

#include <algorithm>
#include <utility>

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
    std::size_t number = 0;
    for (const FacetGroup& group : groups.groups) {
        ASSERT_GE(group.count, 1);
        ASSERT_LE(group.count, float_lanes);
        for (int lane = 0; lane < float_lanes; ++lane) {
            const std::int32_t facet = group.facet[lane];
            for (int k = 0; k < 3; ++k)
                EXPECT_EQ(groups.points[group.corner[k][lane]], part.corners(facet)[k]);
            if (lane < group.count) {
                ++seen[facet];
                EXPECT_EQ(groups.centroids[number++], facets.centroids[facet]);
            } else {
                EXPECT_EQ(facet, group.facet[group.count - 1]);
            }
        }
    }
    EXPECT_EQ(groups.centroids.size(), number);
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

// A square has 2 a^2 facets. A group of eight covers 4 / a^2 of it, or slightly more.
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
