// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/detail/drawn_mesh.h"

#include <algorithm>
#include <numbers>
#include <set>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "test_meshes.h"

namespace endmill {
namespace {

double area(std::span<const Vec3> points, std::span<const Triangle> triangles)
{
    double sum = 0;
    for (const auto& [a, b, c] : triangles)
        sum += (points[b] - points[a]).cross(points[c] - points[a]).norm() / 2;
    return sum;
}

TEST(DrawnMesh, IsTheMeshWhereThereIsRoom)
{
    const TriangleMesh mesh = test::torus_mesh(20, 10);
    const DrawnMesh drawn = drawn_mesh(mesh.points(), mesh.triangles(), 400);
    EXPECT_TRUE(std::ranges::equal(drawn.triangles, mesh.triangles()));
    for (std::size_t k = 0; k < drawn.facets.size(); ++k)
        EXPECT_EQ(drawn.facets[k], k);
}

// A finely triangulated torus keeps its shape: the area stays that of the torus.
TEST(DrawnMesh, KeepsTheShapeWithFewerTriangles)
{
    const TriangleMesh mesh = test::torus_mesh(500, 200);
    for (const std::size_t most : {50'000U, 20'000U, 5'000U}) {
        const DrawnMesh drawn = drawn_mesh(mesh.points(), mesh.triangles(), most);
        EXPECT_LE(drawn.triangles.size(), most);
        EXPECT_GT(drawn.triangles.size(), most / 20);
        const double expected = 4 * std::numbers::pi * std::numbers::pi * 3;
        EXPECT_NEAR(area(mesh.points(), drawn.triangles) / expected, 1, 0.1);
    }
}

TEST(DrawnMesh, NamesAFacetNearby)
{
    const TriangleMesh mesh = test::torus_mesh(300, 100);
    const DrawnMesh drawn = drawn_mesh(mesh.points(), mesh.triangles(), 10'000);
    ASSERT_EQ(drawn.facets.size(), drawn.triangles.size());
    std::set<std::size_t> facets;
    for (std::size_t k = 0; k < drawn.facets.size(); ++k) {
        facets.insert(drawn.facets[k]);
        const Vec3 corner = mesh.points()[drawn.triangles[k][0]];
        double nearest = 10;
        for (const Vec3& other : mesh.corners(drawn.facets[k]))
            nearest = std::min(nearest, (corner - other).norm());
        // A cell's diagonal for the merged points, and as much for the collapsed edges.
        EXPECT_LT(nearest, 2 * 8.0 / 32 * std::numbers::sqrt3);
    }
    EXPECT_EQ(facets.size(), drawn.facets.size());
}

// Tiny triangles far from each other, all smaller than a cube of any grid.
TEST(DrawnMesh, KeepsSomeTrianglesOfTinyParts)
{
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    for (int k = 0; k < 1000; ++k) {
        const Vec3 place{1000.0 * k, 0, 0};
        points.insert(points.end(),
                      {place, place + Vec3{1, 0, 0}, place + Vec3{0, 1, 0}});
        triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
    }
    const DrawnMesh drawn = drawn_mesh(points, triangles, 100);
    EXPECT_LE(drawn.triangles.size(), 100U);
    EXPECT_GT(drawn.triangles.size(), 0U);
}

TEST(DrawnMesh, AcceptsASinglePointAndAnEmptyMesh)
{
    const std::vector<Vec3> points(3, Vec3{1, 1, 1});
    const std::vector<Triangle> triangles(7, Triangle{0, 1, 2});
    EXPECT_EQ(drawn_mesh(points, triangles, 2).triangles.size(), 2U);
    EXPECT_TRUE(drawn_mesh({}, {}, 1).triangles.empty());
    EXPECT_THROW(drawn_mesh({}, {}, 0), DomainError);
}

}  // namespace
}  // namespace endmill
