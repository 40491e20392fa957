// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/decimation.h"

#include <algorithm>
#include <numbers>
#include <set>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/mesh/mesh_checks.h"
#include "endmill/mesh/triangle_tree.h"
#include "test_meshes.h"

namespace endmill {
namespace {

// Points less edges plus triangles: 0 for a torus, 1 for a disc, 2 for a sphere.
std::ptrdiff_t euler_characteristic(const TriangleMesh& mesh)
{
    std::set<MeshEdge> edges;
    std::set<std::int32_t> points;
    for (const Triangle& triangle : mesh.triangles())
        for (int k = 0; k < 3; ++k) {
            points.insert(triangle[k]);
            const auto [low, high] = std::minmax({triangle[k], triangle[(k + 1) % 3]});
            edges.insert({low, high});
        }
    return std::ssize(points) - std::ssize(edges) + std::ssize(mesh.triangles());
}

void expect_named(const TriangleMesh& given, const DecimatedMesh& coarse)
{
    ASSERT_EQ(coarse.source_points.size(), coarse.mesh.points().size());
    ASSERT_EQ(coarse.source_triangles.size(), coarse.mesh.triangles().size());
    EXPECT_TRUE(std::ranges::is_sorted(coarse.source_points));
    for (std::size_t k = 0; k < coarse.source_points.size(); ++k)
        EXPECT_EQ(coarse.mesh.points()[k], given.points()[coarse.source_points[k]]);
    EXPECT_TRUE(std::ranges::is_sorted(coarse.source_triangles));
    EXPECT_EQ(std::ranges::adjacent_find(coarse.source_triangles),
              coarse.source_triangles.end());
}

TEST(Decimated, IsTheMeshIfThatHasNoMoreTriangles)
{
    const TriangleMesh torus = test::torus_mesh(9, 5);
    const DecimatedMesh same = decimated(torus, 90);
    EXPECT_TRUE(std::ranges::equal(same.mesh.triangles(), torus.triangles()));
    EXPECT_TRUE(std::ranges::equal(same.mesh.points(), torus.points()));
    expect_named(torus, same);
}

// The square of 40 by 30 mm needs only its four corners and two triangles.
TEST(Decimated, LeavesAPlanePlaneWithItsOutline)
{
    const TriangleMesh square = test::flat_mesh(40, 30);
    const DecimatedMesh coarse = decimated(square, 2);
    EXPECT_EQ(coarse.mesh.triangles().size(), 2U);
    expect_named(square, coarse);
    const MeshReport report = mesh_report(coarse.mesh);
    EXPECT_EQ(report.area, 1200);
    EXPECT_EQ(boundary_loops(coarse.mesh).front().length, 140);
    for (const Vec3& point : coarse.mesh.points())
        EXPECT_EQ(point.z(), 0);
}

// The torus stays closed, with Euler characteristic 0 and nearly its volume 2 pi^2 R r^2.
TEST(Decimated, KeepsTheTopologyAndNearlyTheVolumeOfATorus)
{
    const TriangleMesh torus = test::torus_mesh(120, 40);
    const double volume = 2 * std::numbers::pi * std::numbers::pi * 3;
    for (const auto& [most, share] : {std::pair{4000U, 0.01}, {1000U, 0.03}}) {
        const DecimatedMesh coarse = decimated(torus, most);
        EXPECT_LE(coarse.mesh.triangles().size(), most);
        EXPECT_GE(coarse.mesh.triangles().size(), most - 2);
        expect_named(torus, coarse);
        const MeshReport report = mesh_report(coarse.mesh);
        EXPECT_TRUE(report.closed);
        EXPECT_EQ(report.non_manifold_edges, 0U);
        EXPECT_EQ(report.inconsistent_edges, 0U);
        EXPECT_EQ(report.components, 1U);
        EXPECT_EQ(euler_characteristic(coarse.mesh), 0);
        ASSERT_TRUE(report.volume);
        EXPECT_NEAR(*report.volume / volume, 1, share);
    }
}

// The replaced triangle lies near the one that replaces it.
TEST(Decimated, NamesATriangleNearEachOne)
{
    const TriangleMesh torus = test::torus_mesh(120, 40);
    const DecimatedMesh coarse = decimated(torus, 2000);
    for (std::size_t k = 0; k < coarse.mesh.triangles().size(); ++k) {
        const auto corners = coarse.mesh.corners(k);
        double longest = 0;
        for (int side = 0; side < 3; ++side)
            longest = std::max(longest, (corners[side] - corners[(side + 1) % 3]).norm());
        const auto given = torus.corners(coarse.source_triangles[k]);
        const Vec3 middle = (given[0] + given[1] + given[2]) / 3;
        EXPECT_LT((nearest_on_triangle(middle, corners) - middle).norm(), 2 * longest);
    }
}

TEST(Decimated, DoesNotDependOnPlaceAndSize)
{
    const TriangleMesh torus = test::torus_mesh(60, 20);
    const DecimatedMesh coarse = decimated(torus, 500);
    std::vector<Vec3> far;
    for (const Vec3& point : torus.points())
        far.emplace_back(1024 * point + Vec3{1 << 20, -(1 << 20), 1 << 18});
    const DecimatedMesh other = decimated({far, test::triangles_of(torus)}, 500);
    EXPECT_LE(other.mesh.triangles().size(), 500U);
    EXPECT_EQ(euler_characteristic(other.mesh), 0);
    EXPECT_EQ(other.mesh.triangles().size(), coarse.mesh.triangles().size());
}

// Isolated triangles cannot be collapsed.
TEST(Decimated, StopsWhereNoCollapseIsPossible)
{
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    for (int k = 0; k < 20; ++k) {
        const Vec3 place{10.0 * k, 0, 0};
        points.insert(points.end(),
                      {place, place + Vec3{1, 0, 0}, place + Vec3{0, 1, 0}});
        triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
    }
    EXPECT_EQ(decimated({points, triangles}, 5).mesh.triangles().size(), 20U);
    EXPECT_EQ(decimated({points, triangles}, 0).mesh.triangles().size(), 20U);
}

// Random triangles over few points: non-manifold nearly everywhere, some degenerate.
TEST(Decimated, AcceptsNonManifoldMeshes)
{
    test::Random random{11};
    for (int trial = 0; trial < 100; ++trial) {
        std::vector<Vec3> points;
        const int count = 4 + trial % 20;
        for (int k = 0; k < count; ++k)
            points.push_back(test::random_point(random, 9));
        const auto number = [&] {
            return static_cast<std::int32_t>(random.uniform(0, count));
        };
        std::vector<Triangle> triangles;
        for (int k = 0; k < 4 * count; ++k)
            triangles.push_back({number(), number(), number()});
        const TriangleMesh mesh{points, triangles};
        const DecimatedMesh coarse = decimated(mesh, 3);
        EXPECT_LE(coarse.mesh.triangles().size(), mesh.triangles().size());
        expect_named(mesh, coarse);
    }
}

TEST(Decimated, IsTheSameEachTime)
{
    const TriangleMesh torus = test::torus_mesh(60, 20);
    EXPECT_TRUE(std::ranges::equal(decimated(torus, 300).mesh.triangles(),
                                   decimated(torus, 300).mesh.triangles()));
}

}  // namespace
}  // namespace endmill
