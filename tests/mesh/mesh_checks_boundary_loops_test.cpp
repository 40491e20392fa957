// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <gtest/gtest.h>

#include "endmill/mesh/mesh_checks.h"
#include "test_meshes.h"

namespace endmill {
namespace {

using Numbers = std::vector<std::int32_t>;

std::vector<Numbers> loop_points(const TriangleMesh& mesh)
{
    std::vector<Numbers> points;
    for (const BoundaryLoop& loop : boundary_loops(mesh))
        points.push_back(loop.points);
    return points;
}

// Points on a curve in space, no three of which are collinear.
std::vector<Vec3> points(int count)
{
    std::vector<Vec3> points;
    for (int k = 0; k < count; ++k)
        points.emplace_back(k, k * k, k * k * k);
    return points;
}

TEST(BoundaryLoops, OfNothingAreNone)
{
    EXPECT_TRUE(boundary_loops(TriangleMesh{}).empty());
    EXPECT_TRUE(boundary_loops(TriangleMesh{points(3), {}}).empty());
}

TEST(BoundaryLoops, OfAClosedMeshAreNone)
{
    EXPECT_TRUE(boundary_loops(test::torus_mesh(5, 4)).empty());
}

// The grid of 3 by 3 unit cells lacks the two triangles of its middle cell, whose points are
// 5, 6, 10 and 9.
TEST(BoundaryLoops, RunCounterClockwiseAroundTheMeshAndClockwiseAroundAHole)
{
    const TriangleMesh grid = test::flat_mesh(3, 3);
    std::vector<Triangle> triangles = test::triangles_of(grid);
    triangles.erase(triangles.begin() + 8, triangles.begin() + 10);
    const TriangleMesh mesh{test::points_of(grid), triangles};
    EXPECT_EQ(
        loop_points(mesh),
        (std::vector<Numbers>{{0, 1, 2, 3, 7, 11, 15, 14, 13, 12, 8, 4}, {5, 9, 10, 6}}));
    const auto loops = boundary_loops(mesh);
    EXPECT_EQ(loops[0].length, 12);
    EXPECT_EQ(loops[1].length, 4);
}

// Random subsets of a torus's triangles. The loops together contain every boundary edge
// of the report exactly once.
TEST(BoundaryLoops, HaveTheBoundaryEdgesOfAManifoldMeshOnceEach)
{
    test::Random random{2};
    for (int trial = 0; trial < 384; ++trial) {
        const TriangleMesh torus = test::torus_mesh(12, 8);
        std::vector<Triangle> triangles = test::triangles_of(torus);
        std::ranges::shuffle(triangles, random.engine());
        triangles.resize(trial % 192 + 1);
        const TriangleMesh mesh{test::points_of(torus), triangles};
        std::size_t edges = 0;
        for (const BoundaryLoop& loop : boundary_loops(mesh))
            edges += loop.points.size();
        EXPECT_EQ(edges, mesh_report(mesh).boundary_edges);
    }
}

// A fan around one point, with its triangles in random order.
TEST(BoundaryLoops, DoNotDependOnTheOrderOfTriangles)
{
    std::vector<Triangle> fan(7);
    for (int k = 0; k < 7; ++k)
        fan[k] = {0, 1 + k, 1 + (k + 1) % 7};
    test::Random random{3};
    for (int trial = 0; trial < 200; ++trial) {
        std::ranges::shuffle(fan, random.engine());
        EXPECT_EQ(loop_points({points(8), fan}),
                  (std::vector<Numbers>{{1, 2, 3, 4, 5, 6, 7}}));
    }
}

// Two pieces that touch at a point have a loop each.
TEST(BoundaryLoops, AreTheSameWithThePointsAtBreaks)
{
    test::Random random{7};
    for (int round = 0; round < 20; ++round) {
        std::vector<Triangle> triangles = test::triangles_of(test::torus_mesh(12, 8));
        std::ranges::shuffle(triangles, random.engine());
        triangles.resize(triangles.size() - 10 * round);
        std::swap(triangles[0][0], triangles[0][round % 3]);
        const TriangleMesh mesh{test::points_of(test::torus_mesh(12, 8)), triangles};
        const auto loops = boundary_loops(mesh, mesh_report(mesh).points_at_breaks);
        ASSERT_EQ(loops.size(), loop_points(mesh).size());
        for (std::size_t k = 0; k < loops.size(); ++k)
            EXPECT_EQ(loops[k].points, loop_points(mesh)[k]);
    }
}

TEST(BoundaryLoops, PassAPointOfTwoFansTwice)
{
    EXPECT_EQ(loop_points({points(5), {{0, 1, 2}, {0, 3, 4}}}),
              (std::vector<Numbers>{{0, 1, 2}, {0, 3, 4}}));
}

// Three triangles at one edge are three pieces.
TEST(BoundaryLoops, ArePartedAtNonManifoldEdges)
{
    EXPECT_EQ(loop_points({points(5), {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}}),
              (std::vector<Numbers>{{0, 1, 2}, {0, 3, 1}, {0, 1, 4}}));
}

TEST(BoundaryLoops, ArePartedAtInconsistentEdges)
{
    EXPECT_EQ(loop_points({points(4), {{0, 1, 2}, {0, 1, 3}}}),
              (std::vector<Numbers>{{0, 1, 2}, {0, 1, 3}}));
}

// Two closed tetrahedra share the edge 0-1, of four triangles.
TEST(BoundaryLoops, OfBodiesThatTouchAlongAnEdgeAreNone)
{
    const std::vector<Triangle> triangles{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3},
                                          {0, 4, 1}, {0, 1, 5}, {1, 4, 5}, {4, 0, 5}};
    const TriangleMesh mesh{points(6), triangles};
    EXPECT_EQ(mesh_report(mesh).non_manifold_edges, 1U);
    EXPECT_TRUE(boundary_loops(mesh).empty());
}

TEST(BoundaryLoops, LeaveOutTrianglesThatRepeatACorner)
{
    EXPECT_EQ(loop_points({points(3), {{0, 1, 2}, {2, 1, 2}}}),
              (std::vector<Numbers>{{0, 1, 2}}));
}

// A band of five triangles, whose ends are joined after half a turn, cannot be oriented.
TEST(BoundaryLoops, OfAMoebiusStripEnd)
{
    const TriangleMesh strip{points(5),
                             {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 0}, {4, 0, 1}}};
    ASSERT_GT(mesh_report(strip).inconsistent_edges, 0U);
    std::size_t edges = 0;
    for (const BoundaryLoop& loop : boundary_loops(strip))
        edges += loop.points.size();
    EXPECT_GE(edges, mesh_report(strip).boundary_edges);
}

}  // namespace
}  // namespace endmill
