// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/ball_on_mesh.h"

#include <gtest/gtest.h>

#include "test_meshes.h"

namespace endmill {
namespace {

// A floor at z = 0 for x < 0 and a slope that rises from x = 0 at an angle.
TriangleMesh corner_mesh(double angle)
{
    const Vec3 rise{std::cos(angle), 0, std::sin(angle)};
    std::vector<Vec3> points;
    for (const double y : {-50.0, 50.0}) {
        points.emplace_back(-60, y, 0);
        points.emplace_back(0, y, 0);
        points.emplace_back(60 * rise + y * Vec3::UnitY());
    }
    return {points, {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}}};
}

constexpr double tolerance = 0.01;

class BallInACorner : public testing::TestWithParam<double> {};

// In a corner between two planes that rise by the angle the centre of a ball that touches
// both is R tan(angle / 2) from the edge.
TEST_P(BallInACorner, TouchesBothSides)
{
    const double angle = GetParam();
    const TriangleMesh mesh = corner_mesh(angle);
    const BallCutter ball{5};
    const BallOnMesh on_mesh{mesh, ball, tolerance, MeshEdges::Sharp};
    const double touching = 5 * std::tan(angle / 2);
    for (const double share : {0.1, 0.5, 0.9}) {
        const CutterContact seat =
            on_mesh.seated({{-share * touching, 0, 0}, Vec3::UnitZ()});
        const Vec3 centre = seat.point + 5 * seat.normal;
        const Vec3 slope{-std::sin(angle), 0, std::cos(angle)};
        EXPECT_GE(centre.z(), 5 - 1e-6);
        EXPECT_GE(centre.dot(slope), 5 - 1e-6);
        EXPECT_TRUE(on_mesh.is_clear(centre, centre));
        // it keeps a small distance, and slides along one side only
        EXPECT_LT(std::min(centre.z(), centre.dot(slope)), 5 + tolerance);
    }
}

INSTANTIATE_TEST_SUITE_P(FlatToSteep, BallInACorner, testing::Values(0.3, 0.8, 1.3));

TEST(BallOnMesh, KeepsAContactThatDoesNotEnterTheMesh)
{
    const TriangleMesh mesh = test::flat_mesh(20, 20);
    const BallOnMesh smooth{mesh, BallCutter{3}, tolerance, MeshEdges::Smooth};
    const CutterContact at{{7.3, 4.1, 0}, Vec3::UnitZ()};
    EXPECT_EQ(smooth.seated(at).point, at.point);
    const BallOnMesh sharp{mesh, BallCutter{3}, tolerance, MeshEdges::Sharp};
    EXPECT_GT(sharp.seated(at).point.z(), 0);
    EXPECT_LT(sharp.seated(at).point.z(), tolerance);
}

// The depth in a plane is the same everywhere; beside a wall the ball may not enter at all.
TEST(BallOnMesh, CallsMovesClearUpToTheTolerance)
{
    const TriangleMesh mesh = test::flat_mesh(20, 20);
    const BallOnMesh ball{mesh, BallCutter{3}, tolerance, MeshEdges::Smooth};
    EXPECT_TRUE(ball.is_clear({2, 5, 3 - 0.9 * tolerance}, {18, 5, 3}));
    EXPECT_FALSE(ball.is_clear({2, 5, 3 - 1.01 * tolerance}, {18, 5, 3}));
    const TriangleMesh box = test::box_mesh({0, 0, 0}, {20, 20, 20});
    const BallOnMesh beside{box, BallCutter{3}, tolerance, MeshEdges::Sharp};
    EXPECT_TRUE(beside.is_clear({-3.001, 2, 8}, {-3.001, 18, 8}));
    EXPECT_FALSE(beside.is_clear({-2.999, 2, 8}, {-2.999, 18, 8}));
}

TEST(BallOnMesh, ReachesNoPlaceNearAWallThatIsNearerThanItsRadius)
{
    const TriangleMesh mesh = corner_mesh(1.5);
    const BallOnMesh ball{mesh, BallCutter{5}, tolerance, MeshEdges::Sharp};
    EXPECT_TRUE(ball.is_accessible({{-6, 0, 0}, Vec3::UnitZ()}, 0.05));
    EXPECT_FALSE(ball.is_accessible({{-2, 0, 0}, Vec3::UnitZ()}, 0.05));
}

}  // namespace
}  // namespace endmill
