// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/part_collisions.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/verification/detail/body_place.h"
#include "random.h"
#include "test_meshes.h"
#include "test_surfaces.h"
#include "tip_path.h"

namespace endmill {
namespace {

using test::tip_path;

// A floor at z = 0 up to x = 0, an upright wall there, and a terrace of the given height.
TriangleMesh step(double height)
{
    return test::grid_mesh(3, 1, [&](int i, int j) {
        return Vec3{i == 0   ? -40.0
                    : i == 3 ? 40.0
                             : 0.0,
                    j == 0 ? -30.0 : 30.0, i >= 2 ? height : 0.0};
    });
}

// A move along the wall of a step of 20 mm, on the floor, `away` mm from the wall.
PartCollisions beside_step(double away, const ToolCylinder& body)
{
    ToolPath path = tip_path({{-away, -10, 0}, {-away, 10, 0}});
    path.points[0].move = Move::Rapid;
    return part_collisions(step(20), path, Cutter::flat(3), std::vector{body});
}

TEST(PartCollisions, OfAHolderBesideAWallHaveTheDepthOfTheOverlap)
{
    const PartCollisions found = beside_step(4, {12, 10, 60});
    EXPECT_EQ(found.moves.count, 1U);
    EXPECT_EQ(found.moves.first, 1U);
    EXPECT_NEAR(found.moves.deepest, 2, found.error_mm + 1e-12);
    EXPECT_LE(found.moves.deepest, 2 + 1e-12);
    EXPECT_LE(found.error_mm, 0.021);
    ASSERT_TRUE(found.deepest);
    EXPECT_NEAR(found.deepest->point.x(), 0, found.error_mm + 1e-12);
    EXPECT_GE(found.deepest->point.z(), 12 - 1e-12);
    EXPECT_EQ(found.deepest->move, 1U);
}

// The cylinder's lower end is 1 below the edge of the wall, so the shortest way out is
// down.
TEST(PartCollisions, HaveTheDepthOfTheShortestWayOut)
{
    const PartCollisions found = beside_step(4, {12, 19, 60});
    EXPECT_NEAR(found.moves.deepest, 1, found.error_mm);
    EXPECT_LE(found.moves.deepest, 1);
    EXPECT_LE(found.error_mm, 0.011);
}

TEST(PartCollisions, OfAShankBesideAStepAreNoneWhereItIsClear)
{
    const ToolCylinder shank{7, 5, 60};
    EXPECT_EQ(beside_step(3.6, shank).moves.count, 0U);
    EXPECT_EQ(beside_step(3.5, shank).moves.count, 0U);  // the shank touches the wall
    EXPECT_EQ(beside_step(3.5, shank).bound_mm, part_contact_slack);
    EXPECT_EQ(beside_step(3.49, shank).moves.count, 1U);
    EXPECT_NEAR(beside_step(3.49, shank).moves.deepest, 0.01, 1e-3);
    // the cylinder slides on the top
    EXPECT_EQ(beside_step(3.4, {7, 20, 60}).moves.count, 0U);
    EXPECT_EQ(beside_step(3.4, {7, 20.5, 60}).moves.count, 0U);
}

// The cutter is open above. Contacts inside it are reported as gouges of the cutter.
TEST(PartCollisions, IgnoreThePartInsideTheCutter)
{
    EXPECT_EQ(beside_step(2.5, {6, 5, 60}).moves.count, 0U);
    EXPECT_FALSE(reaches_out({6, 5, 60}, Cutter::flat(3)));
    EXPECT_TRUE(reaches_out({6.1, 5, 60}, Cutter::flat(3)));
    EXPECT_FALSE(reaches_out({6, 3, 60}, Cutter::ball(3)));
    EXPECT_TRUE(reaches_out({6, 2, 60}, Cutter::ball(3)));
}

// The contact lies on the uphill side of the plane, x from the axis, where x t - b = rho
// - x.
TEST(PartCollisions, WithATiltedPlaneAreThoseOfTheClosedForm)
{
    const double t = 0.5;
    const double rho = 8;
    const double end = 1.5;  // height of the holder's end over the plane at the axis
    const double expected = rho - (rho + end) / (1 + t);
    const Surface plane = test::parallelogram({60, 0, 60 * t}, {0, 60, 0});
    const ToolPath path = tip_path({{30, 30, 30 * t}, {30, 30, 30 * t}});
    const std::vector<ToolCylinder> body{{2 * rho, end, 50}};
    for (const Part& part :
         {Part{std::vector{plane}}, Part{test::grid_mesh(7, 5, [&](int i, int j) {
              return Vec3{60.0 * i / 7, 12.0 * j, 60.0 * i / 7 * t};
          })}}) {
        const PartCollisions found = part_collisions(part, path, Cutter::ball(2), body);
        EXPECT_EQ(found.moves.count, 2U);
        EXPECT_LE(found.moves.deepest, expected + 1e-9);
        EXPECT_GE(found.moves.deepest + found.error_mm, expected - 1e-9);
        EXPECT_LE(found.error_mm, 0.03 * expected);
        ASSERT_TRUE(found.deepest);
        EXPECT_LT((found.deepest->point -
                   Vec3{30 + rho - expected, 30, (30 + rho - expected) * t})
                      .norm(),
                  1.5);
    }
}

// A cylinder whose lower end passes `under` mm below the top of a ridge.
PartCollisions over_ridge(double under)
{
    const Part part = std::vector{test::parabolic_cylinder(-0.05, 20, 30)};
    ToolPath path = tip_path({{-3, 12, -10 - under}, {3, 18, -10 - under}});
    path.points[0].move = Move::Rapid;
    return part_collisions(part, path, Cutter::flat(1),
                           std::vector<ToolCylinder>{{10, 10, 50}});
}

TEST(PartCollisions, WithACurvedPartAreCertainBeyondTheSlack)
{
    for (const double under : {-1.0, -0.01, -0.001, 0.0}) {
        EXPECT_EQ(over_ridge(under).moves.count, 0U) << under;
        EXPECT_LE(over_ridge(under).bound_mm, closed_contact_bound) << under;
    }
    for (const double under : {0.0025, 0.01, 0.3, 2.0}) {
        const PartCollisions found = over_ridge(under);
        EXPECT_EQ(found.moves.count, 1U) << under;
        EXPECT_LE(found.moves.deepest, under + 1e-9);
        EXPECT_GE(found.moves.deepest + found.error_mm, under - 1e-9);
        EXPECT_LE(found.error_mm, std::max(0.001, 0.05 * under));
    }
}

// The corners of a mesh lie on the part. None is deeper than the result with its error
// bound, and every move that has a corner in the body is counted.
TEST(PartCollisions, AreNeverBelowTheDepthAtAPlace)
{
    test::Random random{7};
    const TriangleMesh mesh = test::grid_mesh(40, 40, [&](int i, int j) {
        return Vec3{1.0 * i, 1.0 * j, random.uniform(0, 2)};
    });
    std::vector<Vec3> tips;
    for (int k = 0; k < 60; ++k)
        tips.emplace_back(random.uniform(0, 40), random.uniform(0, 40),
                          random.uniform(-4, 4));
    const ToolPath path = tip_path(tips);
    const ToolCylinder cylinder{6, 4, 40};
    std::size_t count = 0;
    double deepest = 0;
    for (std::size_t k = 0; k < tips.size(); ++k) {
        double depth = 0;
        for (const Vec3& point : mesh.points())
            depth = std::max(
                depth,
                place_in_body({3, 4}, swept_move(tips[k > 0 ? k - 1 : 0], tips[k]), point)
                    .depth);
        count += depth > part_contact_slack ? 1 : 0;
        deepest = std::max(deepest, depth);
    }
    for (const int threads : {1, 2, 3}) {
        set_thread_count(threads);
        const PartCollisions found =
            part_collisions(mesh, path, Cutter::ball(1), std::vector{cylinder});
        EXPECT_GE(found.moves.count, count);
        EXPECT_GE(found.moves.deepest + found.error_mm, deepest);
        static PartCollisions first;
        if (threads == 1)
            first = found;
        EXPECT_EQ(found.moves.count, first.moves.count);
        EXPECT_EQ(found.moves.deepest, first.moves.deepest);
        EXPECT_EQ(found.error_mm, first.error_mm);
        EXPECT_EQ(found.deepest->point, first.deepest->point);
    }
}

TEST(PartCollisions, WithoutBodyPathOrPartAreNone)
{
    const ToolPath path = tip_path({{0, 0, 0}, {1, 0, 0}});
    EXPECT_EQ(part_collisions(step(20), path, Cutter::flat(3), {}).moves.count, 0U);
    EXPECT_EQ(part_collisions(step(20), {}, Cutter::flat(3),
                              std::vector<ToolCylinder>{{12, 10, 60}})
                  .moves.count,
              0U);
    EXPECT_EQ(part_collisions(TriangleMesh{}, path, Cutter::flat(3),
                              std::vector<ToolCylinder>{{12, 10, 60}})
                  .moves.count,
              0U);
}

}  // namespace
}  // namespace endmill
