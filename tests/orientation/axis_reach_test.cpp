// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/axis_reach.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "test_meshes.h"

namespace endmill {
namespace {

using test::both;
using test::box_mesh;

// A floor and a wall beside it, with the corner along y.
TriangleMesh corner()
{
    return both(box_mesh({0, 0, -5}, {30, 30, 0}), box_mesh({-5, 0, -5}, {0, 30, 20}));
}

// A ball of radius R over the floor touches the wall at the distance R from it. Nearer to the
// wall it must be raised, by any axis that both sides face.
TEST(AxisReach, EndsBesideAWallWhereTheBallTouchesBothSides)
{
    const double radius = 4;
    const std::vector<Vec3> axes{Vec3::UnitZ(), Vec3{1, 0, 1}.normalized(),
                                 Vec3{0.3, 0.5, 1}.normalized()};
    const AxisReach reach{corner(), Cutter::ball(radius), axes};
    ASSERT_EQ(reach.axes(), 3U);
    for (std::size_t axis = 0; axis < axes.size(); ++axis)
        for (const double beside : {3.9, 4.1}) {
            const bool is_free = beside > radius;
            EXPECT_EQ(reach.reaches(axis, {{beside, 15, 0}, Vec3::UnitZ()}, 0.01),
                      is_free);
            EXPECT_EQ(reach.reaches({{0, 15, beside}, Vec3::UnitX()}, 0.01), is_free);
        }
}

TEST(AxisReach, IsNothingForPlacesThatFaceAwayOrAreHidden)
{
    const std::vector<Vec3> axes{Vec3::UnitZ(), Vec3::UnitX()};
    const AxisReach reach{corner(), Cutter::ball(2), axes};
    const CutterContact back{{-5, 15, 10}, -Vec3::UnitX()};
    EXPECT_TRUE(reach.reaches(0, back, 0.01));  // an upright wall
    EXPECT_FALSE(reach.reaches(1, back, 0.01));
    const CutterContact bottom{{15, 15, -5}, -Vec3::UnitZ()};
    EXPECT_FALSE(reach.reaches(0, bottom, 0.01));
    EXPECT_TRUE(reach.reaches(bottom, 0.01));  // a wall along x
    // along -x the wall hides the floor
    const std::vector<Vec3> from_behind{-Vec3::UnitX()};
    const AxisReach hidden{corner(), Cutter::ball(2), from_behind};
    EXPECT_FALSE(hidden.reaches({{10, 15, 0}, Vec3::UnitZ()}, 0.01));
}

}  // namespace
}  // namespace endmill
