// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/mesh_repair.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "endmill/mesh/mesh_checks.h"
#include "test_meshes.h"

namespace endmill {
namespace {

const TriangleMesh torus = test::torus_mesh(30, 20);

TriangleMesh inside_out(const TriangleMesh& mesh)
{
    return test::with_turned(mesh, [](std::size_t) { return true; });
}

TriangleMesh cube(double half_side)
{
    return test::box_mesh(Vec3::Constant(-half_side), Vec3::Constant(half_side));
}

double volume(const TriangleMesh& mesh)
{
    return mesh_report(mesh).volume.value();
}

TEST(WithoutDegenerateOrDuplicate, LeavesASoundMeshAsItIs)
{
    const CleanedMesh cleaned = without_degenerate_or_duplicate(torus);
    EXPECT_EQ(cleaned.degenerate_triangles, 0U);
    EXPECT_EQ(cleaned.duplicate_triangles, 0U);
    EXPECT_EQ(test::triangles_of(cleaned.mesh), test::triangles_of(torus));
    EXPECT_TRUE(without_degenerate_or_duplicate(TriangleMesh{}).mesh.triangles().empty());
}

TEST(WithoutDegenerateOrDuplicate, KeepsTheFirstOfEqualTriangles)
{
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    const CleanedMesh cleaned = without_degenerate_or_duplicate(
        {points, {{1, 0, 3}, {0, 1, 2}, {2, 1, 0}, {0, 1, 3}, {2, 4, 3}, {3, 1, 0}}});
    EXPECT_EQ(cleaned.degenerate_triangles, 2U);
    EXPECT_EQ(cleaned.duplicate_triangles, 2U);
    EXPECT_EQ(test::triangles_of(cleaned.mesh),
              (std::vector<Triangle>{{1, 0, 3}, {2, 4, 3}}));
    EXPECT_EQ(cleaned.mesh.points().size(), points.size());
}

TEST(WithoutDegenerateOrDuplicate, LeavesNothingForTheReportToCount)
{
    test::Random random{1};
    std::vector<Vec3> points(27);
    for (int k = 0; k < 27; ++k) {
        const Eigen::Vector3i place{k % 3, k / 3 % 3, k / 9};
        points[k] = place.cast<double>();
    }
    std::vector<Triangle> triangles(800);
    for (Triangle& triangle : triangles)
        for (std::int32_t& corner : triangle)
            corner = static_cast<std::int32_t>(random.uniform(0, 27));
    const TriangleMesh mesh{points, triangles};
    const CleanedMesh cleaned = without_degenerate_or_duplicate(mesh);
    EXPECT_EQ(cleaned.degenerate_triangles, mesh_report(mesh).degenerate_triangles);
    EXPECT_EQ(mesh_report(cleaned.mesh).degenerate_triangles, 0U);
    EXPECT_EQ(mesh_report(cleaned.mesh).duplicate_triangles, 0U);
    EXPECT_EQ(cleaned.mesh.triangles().size(),
              800 - cleaned.degenerate_triangles - cleaned.duplicate_triangles);
}

TEST(Oriented, LeavesAConsistentMeshAsItIs)
{
    const TriangleMesh grid = test::flat_mesh(5, 5);
    for (const TriangleMesh& mesh : {TriangleMesh{}, torus, grid, inside_out(grid)}) {
        const OrientedMesh result = oriented(mesh);
        EXPECT_EQ(result.turned_triangles, 0U);
        EXPECT_EQ(result.unorientable, 0U);
        EXPECT_EQ(test::triangles_of(result.mesh), test::triangles_of(mesh));
    }
}

TEST(Oriented, TurnsAClosedMeshOutwards)
{
    test::Random random{2};
    for (const double share : {0.02, 0.5, 0.9, 1.0}) {
        std::size_t turned = 0;
        const TriangleMesh mesh = test::with_turned(torus, [&](std::size_t) {
            const bool turn = random.uniform(0, 1) < share;
            turned += turn;
            return turn;
        });
        const OrientedMesh result = oriented(mesh);
        EXPECT_EQ(result.turned_triangles, turned);
        EXPECT_EQ(mesh_report(result.mesh).inconsistent_edges, 0U);
        EXPECT_DOUBLE_EQ(volume(result.mesh), volume(torus));
    }
}

TEST(Oriented, TurnsAsFewTrianglesOfAnOpenMeshAsItCan)
{
    const TriangleMesh grid = test::flat_mesh(10, 10);
    const auto few = [](std::size_t k) { return k % 7 == 0; };
    const OrientedMesh up = oriented(test::with_turned(grid, few));
    EXPECT_EQ(test::soup_of(up.mesh), test::soup_of(grid));
    EXPECT_EQ(up.turned_triangles, 29U);  // the triangles 0, 7, ... 196
    const OrientedMesh down = oriented(inside_out(test::with_turned(grid, few)));
    EXPECT_EQ(test::soup_of(down.mesh), test::soup_of(inside_out(grid)));
}

TEST(Oriented, TurnsEachOfSeveralBodiesOutwards)
{
    const TriangleMesh far = test::box_mesh({9, 9, 9}, {10, 10, 10});
    const TriangleMesh in_the_hole = cube(0.5);
    const TriangleMesh mesh =
        test::both(test::both(torus, inside_out(far)), inside_out(in_the_hole));
    const OrientedMesh result = oriented(mesh);
    EXPECT_EQ(result.turned_triangles, 24U);
    EXPECT_NEAR(volume(result.mesh), volume(torus) + 2, 1e-12);
}

TEST(Oriented, KeepsCavitiesAndBodiesInsideAnother)
{
    const TriangleMesh cavity = test::both(cube(2), inside_out(cube(1)));
    const TriangleMesh body = test::both(cube(1), cube(2));
    for (const TriangleMesh& mesh : {cavity, body}) {
        EXPECT_EQ(oriented(mesh).turned_triangles, 0U);
        const OrientedMesh turned_back = oriented(inside_out(mesh));
        EXPECT_EQ(turned_back.turned_triangles, 24U);
        EXPECT_EQ(test::soup_of(turned_back.mesh), test::soup_of(mesh));
    }
}

TEST(Oriented, TurnsPiecesInACavityWithTheOutermostPiece)
{
    const TriangleMesh nested =
        test::both(test::both(cube(1), inside_out(cube(2))), cube(3));
    EXPECT_EQ(oriented(nested).turned_triangles, 0U);
    const OrientedMesh result = oriented(inside_out(nested));
    EXPECT_EQ(test::soup_of(result.mesh), test::soup_of(nested));
}

// Boxes, some of which have triangles that face inwards.
struct Boxes {
    std::vector<Vec3> low;
    std::vector<Vec3> high;
    std::vector<bool> inwards;

    void add(const Vec3& a, const Vec3& b, bool is_inwards)
    {
        low.push_back(a);
        high.push_back(b);
        inwards.push_back(is_inwards);
    }
    TriangleMesh mesh() const
    {
        std::vector<Vec3> points;
        std::vector<Triangle> triangles;
        for (std::size_t k = 0; k < low.size(); ++k) {
            const auto shift = static_cast<std::int32_t>(points.size());
            const TriangleMesh box = test::box_mesh(low[k], high[k]);
            points.insert(points.end(), box.points().begin(), box.points().end());
            for (auto [p, q, r] : box.triangles()) {
                if (inwards[k])
                    std::swap(q, r);
                triangles.push_back({p + shift, q + shift, r + shift});
            }
        }
        return {std::move(points), std::move(triangles)};
    }
    double size(std::size_t k) const { return (high[k] - low[k]).prod(); }
    // By comparing all pairs: a box encloses another if its sides do.
    std::size_t outermost_around(std::size_t inner) const
    {
        std::size_t outermost = inner;
        for (std::size_t k = 0; k < low.size(); ++k)
            if ((low[k].array() < low[inner].array()).all() &&
                (high[k].array() > high[inner].array()).all() &&
                size(k) > size(outermost))
                outermost = k;
        return outermost;
    }
};

TEST(Oriented, TurnsThousandsOfBodiesInAPlaneAcrossAnAxisAtOnce)
{
    for (int axis = 0; axis < 3; ++axis) {
        Boxes boxes;
        for (int k = 0; k < 20'000; ++k) {
            Vec3 low = Vec3::Zero();
            low[(axis + 1) % 3] = 2 * (k % 100);
            low[(axis + 2) % 3] = 2 * (k / 100);
            boxes.add(low, low + Vec3::Ones(), k % 4 == 0);
        }
        const OrientedMesh result = oriented(boxes.mesh());
        EXPECT_EQ(result.turned_triangles, 12U * 5000);
        EXPECT_NEAR(volume(result.mesh), 20'000, 1e-7);
    }
}

TEST(Oriented, TurnsThousandsOfNestedShellsWithTheOutermostAtOnce)
{
    test::Random random{3};
    for (const bool outermost_inwards : {true, false}) {
        Boxes shells;
        for (int k = 1; k < 5000; ++k)
            shells.add(Vec3::Constant(-k), Vec3::Constant(k), random.uniform(0, 1) < 0.5);
        shells.add(Vec3::Constant(-5000), Vec3::Constant(5000), outermost_inwards);
        EXPECT_EQ(oriented(shells.mesh()).turned_triangles,
                  outermost_inwards ? 12U * 5000 : 0U);
    }
}

TEST(Oriented, OfRandomBoxesEqualsTheResultOfTestingAllPairs)
{
    test::Random random{4};
    for (const double largest : {0.2, 2.0, 9.0}) {
        Boxes boxes;
        for (int k = 0; k < 1000; ++k) {
            const Vec3 centre = test::random_point(random, 10);
            Vec3 half;
            for (double& side : half)
                side = largest * random.uniform(0.01, 1) * random.uniform(0.01, 1);
            boxes.add(centre - half, centre + half, random.uniform(0, 1) < 0.5);
        }
        const TriangleMesh given = boxes.mesh();
        const OrientedMesh result = oriented(given);
        for (std::size_t k = 0; k < boxes.low.size(); ++k) {
            const bool turned =
                result.mesh.triangles()[12 * k] != given.triangles()[12 * k];
            EXPECT_EQ(turned, boxes.inwards[boxes.outermost_around(k)]) << k;
        }
    }
}

TEST(Oriented, DistinguishesTheInsideOfATorusFromItsHole)
{
    test::Random random{5};
    const std::vector<Vec3> on_torus = test::points_of(torus);
    for (const bool is_level_with_its_points : {false, true}) {
        Boxes boxes;
        std::size_t inside = 0;
        while (boxes.low.size() < 400) {
            Vec3 place = test::random_point(random, 3.9);
            place.z() /= 4;
            if (is_level_with_its_points) {
                const auto k = static_cast<std::size_t>(random.uniform(0, 600));
                place.tail<2>() = on_torus[k].tail<2>();
            }
            const double from_circle =
                std::hypot(std::hypot(place.x(), place.y()) - 3, place.z());
            if (std::abs(place.z()) > 0.98 || std::abs(from_circle - 1) < 0.05)
                continue;
            boxes.add(place, place + Vec3::Constant(1e-3), false);
            inside += from_circle < 1;
        }
        ASSERT_GT(inside, 50U);
        ASSERT_LT(inside, 350U);
        const OrientedMesh result = oriented(test::both(inside_out(torus), boxes.mesh()));
        EXPECT_EQ(result.turned_triangles, torus.triangles().size() + 12 * inside);
    }
}

TEST(Oriented, LeavesAMoebiusStripUnchangedAndReportsIt)
{
    // Five triangles over five points: each point with the next two.
    std::vector<Vec3> points;
    std::vector<Triangle> strip;
    for (int k = 0; k < 5; ++k) {
        points.emplace_back(std::cos(k), std::sin(k), k % 2);
        strip.push_back({k, (k + 1) % 5, (k + 2) % 5});
    }
    const OrientedMesh result = oriented({points, strip});
    EXPECT_EQ(result.unorientable, 1U);
    EXPECT_EQ(result.turned_triangles, 0U);
    EXPECT_EQ(test::triangles_of(result.mesh), strip);
}

TEST(Oriented, TurnsBodiesThatTouchAlongAnEdgeOutwards)
{
    std::vector<Vec3> points = test::points_of(cube(1));
    std::vector<Triangle> triangles = test::triangles_of(inside_out(cube(1)));
    const TriangleMesh other = test::box_mesh({1, 1, -1}, {3, 3, 1});
    points.insert(points.end(), other.points().begin(), other.points().end());
    for (Triangle triangle : other.triangles()) {
        for (std::int32_t& corner : triangle)
            corner = corner == 0 ? 3 : corner == 4 ? 7 : corner + 8;
        triangles.push_back(triangle);
    }
    const OrientedMesh result = oriented({points, triangles});
    EXPECT_EQ(result.turned_triangles, 12U);
    EXPECT_DOUBLE_EQ(volume(result.mesh), 16);
}

TEST(Oriented, TreatsAClosedSheetWithoutVolumeAsOpen)
{
    // Two triangles back to back, one that repeats a corner, and one with collinear
    // corners.
    const TriangleMesh sheet{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.3}, {2, 0, 0}},
                             {{0, 2, 1}, {0, 1, 2}, {3, 3, 0}, {0, 3, 3}}};
    EXPECT_EQ(oriented(sheet).turned_triangles, 0U);
}

}  // namespace
}  // namespace endmill
