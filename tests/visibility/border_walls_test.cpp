// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/border_walls.h"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "random.h"
#include "test_meshes.h"

namespace endmill {
namespace {

constexpr double accuracy = 1e-7;

// A rotation whose third row is the direction, for parts within a ball of this radius.
Eigen::Matrix3d rows_along(const Vec3& direction, double radius)
{
    const Vec3 along = direction.normalized();
    const Vec3 across = along.unitOrthogonal();
    Eigen::Matrix3d rows;
    rows << across.transpose(), along.cross(across).transpose(), along.transpose();
    return rows / radius;
}

// The square of side 2 around the origin, at z = 0 and seen from above.
TriangleMesh square()
{
    return test::grid_mesh(16, 16, [](int i, int j) {
        return Vec3{i / 8.0 - 1, j / 8.0 - 1, 0};
    });
}

// The number for all rays that start within a distance of a place.
std::optional<int> exits_around(const BorderWalls& walls, const Eigen::Vector3f& place,
                                float reach)
{
    const Eigen::Matrix3f frame = walls.frame().cast<float>();
    const Eigen::Vector3f centre = frame * place;
    const Eigen::Vector3f half = frame.cwiseAbs().rowwise().sum() * reach;
    return walls.exits(ProjectedBox{centre - half, centre + half});
}

std::optional<int> exits(const TriangleMesh& part, const Vec3& from, const Vec3& along)
{
    BorderWalls walls{part};
    const Eigen::Matrix3d rows = rows_along(along, 4);
    walls.look_along(rows, Vec3::Zero(), accuracy);
    return exits_around(walls, (rows * from).cast<float>(), 1e-6F);
}

TEST(BorderWalls, StandOnBorderEdges)
{
    EXPECT_EQ(BorderWalls{square()}.count(), 64U);
    EXPECT_EQ(BorderWalls{test::torus_mesh(6, 4)}.count(), 0U);
    EXPECT_EQ(BorderWalls{TriangleMesh{}}.count(), 0U);
    // The first row is turned over: the 40 edges between it and the second are used twice in
    // the same sense, and so have two walls.
    const TriangleMesh turned =
        test::with_turned(test::flat_mesh(40, 40), [](std::size_t k) { return k < 80; });
    EXPECT_EQ(BorderWalls{turned}.count(), 240U);
}

TEST(BorderWalls, AreNoneIfTheyWouldBeMany)
{
    EXPECT_EQ(BorderWalls{test::flat_mesh(15, 15)}.count(), 0U);
    EXPECT_EQ(exits(test::flat_mesh(15, 15), {0, 0.3, -1}, Vec3::UnitX()), std::nullopt);
}

// The walls of a square enclose the column below it.
TEST(BorderWalls, AreLeftByRaysFromBelow)
{
    EXPECT_EQ(exits(square(), {0, 0.3, -1}, Vec3::UnitX()), 1);
    EXPECT_EQ(exits(square(), {0, 0.3, 1}, Vec3::UnitX()), 0);
    EXPECT_EQ(exits(square(), {-2, 0.3, -1}, Vec3::UnitX()), 0);  // in and out again
    EXPECT_EQ(exits(square(), {2, 0.3, -1}, Vec3::UnitX()), 0);
    EXPECT_EQ(exits(square(), {0, 0.3, 1}, {0.5, 0, -2}), 1);    // in through the square
    EXPECT_EQ(exits(square(), {-2, 0.3, -1}, {1, 0, 0.7}), -1);  // out through the square
    EXPECT_EQ(exits(square(), {0.2, 0.9, 0.1}, {0, 2, -1}), 0);
    EXPECT_EQ(exits(square(), {0.2, 0.9, 0.1}, {0, 1, -2}), 1);
}

// Walls that follow each other have the line down from their common corner once.
TEST(BorderWalls, AnswerForRaysThroughTheCornersOfTheBorder)
{
    for (int j = -7; j < 8; ++j) {
        EXPECT_EQ(exits(square(), {0, j / 8.0, -1}, Vec3::UnitX()), 1);
        EXPECT_EQ(exits(square(), {-2, j / 8.0, -1}, {1, 0, 0.2}), 0);
        EXPECT_EQ(exits(square(), {-2, j / 8.0, -1}, {1, 0, 0.7}), -1);
    }
}

// Two squares, one above the other, are met twice.
TEST(BorderWalls, AreLeftOnceForEachUseOfAnEdge)
{
    const TriangleMesh twice = test::both(square(), square());
    EXPECT_EQ(exits(twice, {0, 0.3, -1}, Vec3::UnitX()), 2);
    std::vector<Triangle> triangles = test::triangles_of(square());
    triangles.insert(triangles.end(), triangles.begin(), triangles.end());
    const TriangleMesh shared{test::points_of(square()), std::move(triangles)};
    EXPECT_EQ(exits(shared, {0, 0.3, -1}, Vec3::UnitX()), 2);
    EXPECT_EQ(exits(shared, {-2, 0.3, -1}, {1, 0, 0.7}), -2);
}

// A box that the whole border passes has one answer for all its rays.
TEST(BorderWalls, AnswerForBoxesWiderThanAWall)
{
    BorderWalls walls{square()};
    const Eigen::Matrix3d rows = rows_along(Vec3::UnitX(), 4);
    walls.look_along(rows, Vec3::Zero(), accuracy);
    const auto around = [&](const Vec3& place) {
        return exits_around(walls, (rows * place).cast<float>(), 0.15F);
    };
    EXPECT_EQ(around({0, 0, -1}), 1);
    EXPECT_EQ(around({0, 0, 1}), 0);
    EXPECT_EQ(around({0, 3, -1}), 0);
    EXPECT_EQ(around({-3, 0, -1}), 0);
    EXPECT_EQ(around({0, 0, 0.1}), std::nullopt);  // partly above the border
    EXPECT_EQ(around({0, 1, -1}), std::nullopt);   // partly beside it
}

TEST(BorderWalls, LeaveRaysAtTheirEdgesAndDownTheWallsInDoubt)
{
    EXPECT_EQ(exits(square(), {-1, 0.3, 0}, Vec3::UnitX()), std::nullopt);
    EXPECT_EQ(exits(square(), {0, 0.3, 0}, Vec3::UnitX()), std::nullopt);
    EXPECT_EQ(exits(square(), {0, 0.3, -1}, Vec3::UnitZ()), std::nullopt);
    EXPECT_EQ(exits(square(), {0, 0.3, 1}, -Vec3::UnitZ()), std::nullopt);
}

TEST(BorderWalls, OfAClosedPartAreNone)
{
    EXPECT_EQ(exits(test::torus_mesh(6, 4), {0, 0, 0}, Vec3::UnitX()), 0);
}

// A wave over a square grid is a height above each place of the square. So the column below
// it contains what lies lower than the wave. A ray leaves through a wall if it crosses the
// boundary of the square lower than the border is there, which is a line between points
// of the grid.
TEST(BorderWalls, AreTheColumnBelowAHeight)
{
    constexpr int cells = 16;
    constexpr double half = cells / 2.0;
    const auto height = [](int i, int j) { return 0.3 * std::sin(2.0 * i + j); };
    const TriangleMesh part = test::grid_mesh(cells, cells, [&](int i, int j) {
        return Vec3{i - half, j - half, height(i, j)};
    });
    const auto border_height = [&](const Vec3& at) {
        const double i = at.x() + half;
        const double j = at.y() + half;
        const bool along_x = std::abs(std::abs(at.y()) - half) < 1e-9;
        const double place = along_x ? i : j;
        const int first = std::min(static_cast<int>(place), cells - 1);
        const double share = place - first;
        const int other = static_cast<int>(std::round(along_x ? j : i));
        const auto of = [&](int k) {
            return along_x ? height(k, other) : height(other, k);
        };
        return (1 - share) * of(first) + share * of(first + 1);
    };
    BorderWalls walls{part};
    test::Random random{9};
    int undecided = 0;
    int around_undecided = 0;
    for (int k = 0; k < 200; ++k) {
        const Vec3 along = test::random_point(random, 1).normalized();
        const Eigen::Matrix3d rows = rows_along(along, 30);
        walls.look_along(rows, Vec3::Zero(), accuracy);
        for (int m = 0; m < 50; ++m) {
            const Vec3 from = test::random_point(random, half - 0.01);
            // The ray starts over the square; it leaves the square once.
            const double x = ((along.x() > 0 ? half : -half) - from.x()) / along.x();
            const double y = ((along.y() > 0 ? half : -half) - from.y()) / along.y();
            const Vec3 out = from + std::min(x, y) * along;
            const bool leaves = out.z() < border_height(out);
            const Eigen::Vector3f place = (rows * from).cast<float>();
            PlaceLanes places;
            for (int axis = 0; axis < 3; ++axis)
                places.at[axis][m % float_lanes] = place[axis];
            const unsigned lane = 1U << m % float_lanes;
            const ExitLanes found = walls.exits(places, lane);
            undecided += (found.none | found.some) == 0;
            EXPECT_EQ((leaves ? found.none : found.some), 0U);
            EXPECT_EQ((found.none | found.some) & ~lane, 0U);
            const std::optional<int> around = exits_around(walls, place, 1e-3F);
            around_undecided += !around;
            if (around) {
                EXPECT_EQ(*around, leaves ? 1 : 0);
            }
        }
    }
    EXPECT_LT(undecided, 20);
    EXPECT_LT(around_undecided, 300);
}

}  // namespace
}  // namespace endmill
