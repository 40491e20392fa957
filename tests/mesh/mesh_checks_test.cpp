// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/mesh_checks.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/mesh/detail/edge_uses.h"
#include "endmill/mesh/detail/place_order.h"
#include "test_meshes.h"

namespace endmill {
namespace {

const TriangleMesh unit_box = test::box_mesh({0, 0, 0}, {1, 1, 1});

TEST(MeshReport, OfNothingIsZero)
{
    const MeshReport report = mesh_report(TriangleMesh{});
    EXPECT_EQ(report.components, 0U);
    EXPECT_EQ(report.area, 0);
    EXPECT_FALSE(report.closed);
    EXPECT_FALSE(report.volume);
}

TEST(MeshReport, OfABoxHasItsAreaAndVolume)
{
    const MeshReport report = mesh_report(test::box_mesh({1, 2, 3}, {3, 5, 7}));
    EXPECT_EQ(report.boundary_edges, 0U);
    EXPECT_EQ(report.non_manifold_edges, 0U);
    EXPECT_EQ(report.inconsistent_edges, 0U);
    EXPECT_EQ(report.components, 1U);
    EXPECT_TRUE(report.closed);
    EXPECT_DOUBLE_EQ(report.area, 2 * (2 * 3 + 3 * 4 + 4 * 2));
    EXPECT_DOUBLE_EQ(report.volume.value(), 2 * 3 * 4);
}

TEST(MeshReport, OfAMeshInsideOutHasANegativeVolume)
{
    const MeshReport report =
        mesh_report(test::with_turned(unit_box, [](std::size_t) { return true; }));
    EXPECT_DOUBLE_EQ(report.volume.value(), -1);
    EXPECT_EQ(report.inconsistent_edges, 0U);
}

TEST(MeshReport, OfAnOpenGridHasItsRimAndNoVolume)
{
    const MeshReport report = mesh_report(test::flat_mesh(7, 4));
    EXPECT_EQ(report.boundary_edges, 2U * (7 + 4));
    EXPECT_DOUBLE_EQ(report.area, 28);
    EXPECT_FALSE(report.closed);
    EXPECT_FALSE(report.volume);
}

// The second route is the flux of z; the report uses the flux of the whole position.
TEST(MeshReport, OfATorusHasTheVolumeOfTheFluxOfHeight)
{
    const TriangleMesh torus = test::torus_mesh(60, 40);
    double flux = 0;
    for (std::size_t k = 0; k < torus.triangles().size(); ++k) {
        const auto [a, b, c] = torus.corners(k);
        flux += (a + b + c).z() / 3 * (b - a).cross(c - a).z() / 2;
    }
    const MeshReport report = mesh_report(torus);
    EXPECT_TRUE(report.closed);
    EXPECT_NEAR(report.volume.value(), flux, 1e-12 * flux);
}

TEST(MeshReport, HoldsItsAccuracyFarFromTheOrigin)
{
    const Vec3 far{1048576, -2097152, 524288};  // so that the sides of the box stay exact
    const MeshReport report = mesh_report(test::box_mesh(far, far + Vec3{1, 0.5, 0.25}));
    const double products = 12 * std::sqrt(1.25) * std::sqrt(1.3125);
    const double diagonal = std::sqrt(1.3125);
    EXPECT_NEAR(report.area, 2 * (0.5 + 0.125 + 0.25), 1e-15 * products);
    EXPECT_NEAR(report.volume.value(), 0.125, 1e-15 * products * diagonal);
}

TEST(MeshReport, HoldsItsAccuracyOverAMillionTriangles)
{
    // 0.1 is rounded, so the area of a cell is that of the rounded sides.
    constexpr int side = 708;
    const MeshReport report = mesh_report(test::grid_mesh(side, side, [](int i, int j) {
        return Vec3{i * 0.0625, j * 0.1 + 1e-9 * i, 0};
    }));
    const double width = side * 0.0625;
    EXPECT_NEAR(report.area, width * (side * 0.1), 1e-15 * 4 * width * width * 1.6);
}

TEST(MeshReport, NamesTheFirstNonManifoldEdge)
{
    // A fin stands on edge 0-3 of the box, which already has two triangles.
    std::vector<Vec3> points = test::points_of(unit_box);
    std::vector<Triangle> triangles = test::triangles_of(unit_box);
    points.emplace_back(0.5, 0.5, -1);
    triangles.push_back({3, 8, 0});
    const MeshReport report = mesh_report({points, triangles});
    EXPECT_EQ(report.non_manifold_edges, 1U);
    EXPECT_EQ(report.first_non_manifold_edge, (MeshEdge{0, 3}));
    EXPECT_EQ(report.boundary_edges, 2U);
    EXPECT_EQ(report.components, 1U);
    EXPECT_FALSE(report.closed);
    EXPECT_FALSE(report.volume);
    EXPECT_FALSE(mesh_report(unit_box).first_non_manifold_edge);
}

TEST(MeshReport, HasTheVolumeOfBoxesThatShareAnEdge)
{
    // Points 1, 3, 5 and 7 of the box are at x = 1; the second box begins at the edge
    // 3-7.
    std::vector<Vec3> points = test::points_of(unit_box);
    std::vector<Triangle> triangles = test::triangles_of(unit_box);
    const TriangleMesh other = test::box_mesh({1, 1, 0}, {2, 2, 1});
    points.insert(points.end(), other.points().begin(), other.points().end());
    for (Triangle triangle : other.triangles()) {
        for (std::int32_t& corner : triangle)
            corner = corner == 0 ? 3 : corner == 4 ? 7 : corner + 8;
        triangles.push_back(triangle);
    }
    const MeshReport report = mesh_report({points, triangles});
    EXPECT_EQ(report.non_manifold_edges, 1U);
    EXPECT_EQ(report.components, 1U);
    EXPECT_TRUE(report.closed);
    EXPECT_DOUBLE_EQ(report.volume.value(), 2);
}

TEST(MeshReport, CountsTheSidesOfATurnedTriangleAsInconsistent)
{
    const MeshReport report =
        mesh_report(test::with_turned(unit_box, [](std::size_t k) { return k == 4; }));
    EXPECT_EQ(report.inconsistent_edges, 3U);
    EXPECT_TRUE(report.closed);
    EXPECT_FALSE(report.volume);
}

TEST(MeshReport, CountsPiecesThatTouchAtAPointSeparately)
{
    const TriangleMesh two{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},
                           {{0, 1, 2}, {0, 3, 4}}};
    EXPECT_EQ(mesh_report(two).components, 2U);
    EXPECT_EQ(mesh_report(test::both(unit_box, two)).components, 3U);
}

TEST(MeshReport, CountsDegenerateAndDuplicateTriangles)
{
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 0, 0}};
    const MeshReport report = mesh_report({points,
                                           {{0, 1, 3},     // sound
                                            {0, 0, 1},     // repeats a corner
                                            {0, 1, 2},     // collinear corners
                                            {1, 4, 3},     // two equal corners
                                            {3, 0, 1},     // the first triangle again
                                            {1, 0, 3}}});  // the same, turned over
    EXPECT_EQ(report.degenerate_triangles, 3U);
    EXPECT_EQ(report.duplicate_triangles, 2U);
    EXPECT_EQ(report.components, 1U);
}

TEST(MeshReport, DoesNotDependOnTheOrderOfTriangles)
{
    const TriangleMesh mesh = test::both(test::torus_mesh(20, 10), test::flat_mesh(9, 9));
    std::vector<Triangle> triangles = test::triangles_of(mesh);
    test::Random random{1};
    std::ranges::shuffle(triangles, random.engine());
    const MeshReport a = mesh_report(mesh);
    const MeshReport b = mesh_report({test::points_of(mesh), triangles});
    EXPECT_EQ(a.components, 2U);
    EXPECT_EQ(a.components, b.components);
    EXPECT_EQ(a.boundary_edges, b.boundary_edges);
    EXPECT_NEAR(a.area, b.area, 1e-13 * a.area);
}

// A large grid with fins, holes, turned and repeated triangles. With its triangles
// and points in no order, the report is made by another route.
TEST(MeshReport, OfALargeMeshInNoOrderIsThatOfTheMeshInOrder)
{
    const TriangleMesh grid = test::grid_mesh(400, 400, [](int i, int j) {
        return Vec3{double(i), double(j), 0.01 * i * j};
    });
    std::vector<Vec3> points = test::points_of(grid);
    std::vector<Triangle> triangles = test::triangles_of(grid);
    for (std::size_t k = 5; k < 300'000; k += 1000) {
        const auto [a, b, c] = triangles[k];
        triangles.push_back({a, c, b});  // repeats triangle k
        std::swap(triangles[k + 10][0], triangles[k + 10][1]);
        triangles[k + 20] = triangles[k + 20 + 1];
        const auto tip = static_cast<std::int32_t>(points.size());
        points.emplace_back(points[a] + Vec3{0, 0, 5});
        triangles.push_back({triangles[k + 100][0], triangles[k + 100][2], tip});
    }
    const MeshReport report = mesh_report({points, triangles});

    test::Random random{3};
    std::vector<std::int32_t> names(points.size());
    std::iota(names.begin(), names.end(), 0);
    std::ranges::shuffle(names, random.engine());
    std::vector<Vec3> moved(points.size());
    for (std::size_t k = 0; k < names.size(); ++k)
        moved[names[k]] = points[k];
    std::vector<std::int32_t> breaks;
    for (const std::int32_t point : report.points_at_breaks)
        breaks.push_back(names[point]);
    std::ranges::sort(breaks);
    std::ranges::shuffle(triangles, random.engine());
    for (Triangle& triangle : triangles)
        for (std::int32_t& corner : triangle)
            corner = names[corner];
    const TriangleMesh mixed{moved, triangles};
    ASSERT_TRUE(are_scattered(mixed));
    const MeshReport other = mesh_report(mixed);
    EXPECT_GT(report.duplicate_triangles, 0U);
    EXPECT_GT(report.inconsistent_edges, 0U);
    EXPECT_EQ(other.boundary_edges, report.boundary_edges);
    EXPECT_EQ(other.non_manifold_edges, report.non_manifold_edges);
    EXPECT_EQ(other.inconsistent_edges, report.inconsistent_edges);
    EXPECT_EQ(other.components, report.components);
    EXPECT_EQ(other.degenerate_triangles, report.degenerate_triangles);
    EXPECT_EQ(other.duplicate_triangles, report.duplicate_triangles);
    EXPECT_EQ(other.points_at_breaks, breaks);
    EXPECT_NEAR(other.area, report.area, 1e-9 * report.area);
    EXPECT_EQ(other.closed, report.closed);
    std::optional<MeshEdge> first;
    EdgeUses{mixed}.for_each([&](const MeshEdge& edge, std::span<const EdgeUse> uses) {
        if (uses.size() > 2 && !first)
            first = edge;
    });
    EXPECT_EQ(other.first_non_manifold_edge, first);
}

}  // namespace
}  // namespace endmill
