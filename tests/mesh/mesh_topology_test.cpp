// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/detail/mesh_topology.h"

#include <algorithm>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/mesh/mesh_checks.h"
#include "test_meshes.h"

namespace endmill {
namespace {

using Numbers = std::vector<std::int32_t>;

std::string complaint_about(const TriangleMesh& mesh)
{
    try {
        const MeshTopology topology{mesh};
    } catch (const GeometryError& error) {
        return error.what();
    }
    return "none";
}

std::vector<Vec3> points(int count)
{
    return std::vector<Vec3>(count, Vec3::Zero());
}

TEST(MeshTopology, OfNothingIsEmpty)
{
    const MeshTopology topology{TriangleMesh{}};
    EXPECT_TRUE(topology.boundary_loops().empty());
    EXPECT_EQ(topology.components().count, 0U);
}

// By looking for the side among all triangles.
TEST(MeshTopology, FindsTheNeighboursThatRunAlongTheSidesBackwards)
{
    test::Random random{1};
    const TriangleMesh mesh = test::both(test::torus_mesh(9, 5), test::flat_mesh(4, 6));
    std::vector<Triangle> triangles = test::triangles_of(mesh);
    std::ranges::shuffle(triangles, random.engine());
    for (Triangle& triangle : triangles)
        std::rotate(triangle.begin(), triangle.begin() + int(random.uniform(0, 3)),
                    triangle.end());
    const MeshTopology topology{{test::points_of(mesh), triangles}};
    for (std::size_t k = 0; k < triangles.size(); ++k)
        for (int side = 0; side < 3; ++side) {
            std::optional<std::size_t> expected;
            for (std::size_t n = 0; n < triangles.size(); ++n)
                for (int other = 0; other < 3; ++other)
                    if (triangles[n][other] == triangles[k][(side + 1) % 3] &&
                        triangles[n][(other + 1) % 3] == triangles[k][side])
                        expected = n;
            EXPECT_EQ(topology.neighbours(k)[side], expected);
        }
}

TEST(MeshTopology, HasOneRingsCounterClockwise)
{
    // Cells are cut from below left to above right; rows of four points.
    const MeshTopology topology{test::flat_mesh(3, 3)};
    EXPECT_EQ(topology.one_ring(5), (Numbers{0, 1, 6, 10, 9, 4}));
    EXPECT_EQ(topology.one_ring(0), (Numbers{1, 5, 4}));
    EXPECT_EQ(topology.one_ring(1), (Numbers{2, 6, 5, 0}));
    EXPECT_EQ(topology.one_ring(3), (Numbers{7, 2}));
    EXPECT_EQ(topology.one_ring(15), (Numbers{14, 10, 11}));
    EXPECT_TRUE(MeshTopology(TriangleMesh{points(1), {}}).one_ring(0).empty());
}

TEST(MeshTopology, HasOneRingsOfEveryEdgeTwice)
{
    const TriangleMesh torus = test::torus_mesh(11, 7);
    const MeshTopology topology{torus};
    std::size_t ends = 0;
    for (std::int32_t point = 0; point < 77; ++point) {
        const Numbers ring = topology.one_ring(point);
        EXPECT_EQ(std::set<std::int32_t>(ring.begin(), ring.end()).size(), ring.size());
        EXPECT_EQ(ring.front(), *std::ranges::min_element(ring));
        ends += ring.size();
    }
    EXPECT_EQ(ends, 2 * 3 * torus.triangles().size() / 2);
}

TEST(MeshTopology, HasTheRimCounterClockwiseAndAHoleClockwise)
{
    // Without the two triangles of the middle cell, whose points are 5, 6, 10 and 9.
    const TriangleMesh grid = test::flat_mesh(3, 3);
    std::vector<Triangle> triangles = test::triangles_of(grid);
    triangles.erase(triangles.begin() + 8, triangles.begin() + 10);
    const MeshTopology topology{{test::points_of(grid), triangles}};
    EXPECT_EQ(
        topology.boundary_loops(),
        (std::vector<Numbers>{{0, 1, 2, 3, 7, 11, 15, 14, 13, 12, 8, 4}, {5, 9, 10, 6}}));
    EXPECT_EQ(topology.one_ring(5), (Numbers{9, 4, 0, 1, 6}));
}

TEST(MeshTopology, OfAClosedMeshHasNoBoundary)
{
    EXPECT_TRUE(MeshTopology{test::torus_mesh(5, 4)}.boundary_loops().empty());
}

TEST(MeshTopology, CountsAsManyBoundaryEdgesAndPiecesAsTheReport)
{
    test::Random random{2};
    int manifold = 0;
    for (int trial = 0; trial < 384; ++trial) {
        const TriangleMesh torus = test::torus_mesh(12, 8);
        std::vector<Triangle> triangles = test::triangles_of(torus);
        std::ranges::shuffle(triangles, random.engine());
        triangles.resize(trial % 192 + 1);
        const TriangleMesh mesh{test::points_of(torus), triangles};
        if (complaint_about(mesh) != "none")
            continue;
        ++manifold;
        const MeshTopology topology{mesh};
        std::size_t edges = 0;
        for (const Numbers& loop : topology.boundary_loops())
            edges += loop.size();
        EXPECT_EQ(edges, mesh_report(mesh).boundary_edges);
        EXPECT_EQ(topology.components().count, mesh_report(mesh).components);
    }
    EXPECT_GT(manifold, 20);
}

TEST(MeshTopology, NumbersPiecesByTheirFirstTriangles)
{
    const TriangleMesh two{points(7), {{4, 5, 6}, {0, 1, 2}, {5, 4, 3}, {2, 1, 0}}};
    const MeshComponents components = MeshTopology{two}.components();
    EXPECT_EQ(components.count, 2U);
    EXPECT_EQ(components.of_triangle, (Numbers{0, 1, 0, 1}));
}

TEST(MeshTopology, NamesWhereAMeshIsNotManifold)
{
    EXPECT_EQ(complaint_about({points(5), {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}}),
              "MeshTopology: edge 0-1 belongs to 3 triangles");
    EXPECT_EQ(complaint_about({points(4), {{0, 1, 2}, {0, 1, 3}}}),
              "MeshTopology: both triangles of edge 0-1 run along it in the same "
              "direction");
    EXPECT_EQ(complaint_about({points(5), {{0, 1, 2}, {0, 3, 4}}}),
              "MeshTopology: at point 0 triangles meet that no edge there joins");
    EXPECT_EQ(complaint_about({points(3), {{0, 1, 2}, {2, 1, 2}}}),
              "MeshTopology: triangle 1 repeats a corner");
}

TEST(MeshTopology, TakesTrianglesOfAFanInAnyOrder)
{
    // Around one point, so that fans come and go while it is made.
    std::vector<Triangle> fan(7);
    for (int k = 0; k < 7; ++k)
        fan[k] = {0, 1 + k, 1 + (k + 1) % 7};
    test::Random random{3};
    for (int trial = 0; trial < 200; ++trial) {
        std::ranges::shuffle(fan, random.engine());
        const MeshTopology topology{{points(8), fan}};
        EXPECT_EQ(topology.one_ring(0), (Numbers{1, 2, 3, 4, 5, 6, 7}));
        EXPECT_EQ(topology.boundary_loops(),
                  (std::vector<Numbers>{{1, 2, 3, 4, 5, 6, 7}}));
    }
}

TEST(MeshTopology, IsAValueThatCopiesShare)
{
    const MeshTopology original{test::flat_mesh(2, 2)};
    const MeshTopology copy = original;  // NOLINT(performance-unnecessary-copy-*)
    EXPECT_EQ(copy.boundary_loops(), original.boundary_loops());
}

TEST(MeshTopology, RefusesNumbersOfNothing)
{
    const MeshTopology topology{test::flat_mesh(1, 1)};
    EXPECT_THROW(topology.neighbours(2), DomainError);
    EXPECT_THROW(topology.one_ring(4), DomainError);
    EXPECT_THROW(topology.one_ring(-1), DomainError);
}

}  // namespace
}  // namespace endmill
