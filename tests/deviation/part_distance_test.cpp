// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/part_distance.h"

#include <gtest/gtest.h>

#include "revolved_surfaces.h"
#include "test_meshes.h"

namespace endmill {
namespace {

TEST(PartDistance, OfABoxIsToItsFaces)
{
    const Part part = test::box_mesh({0, 0, 0}, {2, 3, 4});
    const PartCharts charts = part_charts(part);
    const PartDistance distance_of{charts, 0.1};
    std::optional<std::size_t> hint;
    const auto distance = [&](const Vec3& place) { return distance_of(place, hint); };
    EXPECT_EQ(distance({1, 1, 6}), 2);
    EXPECT_EQ(distance({5, 7, 4}), 5);
    EXPECT_TRUE(distance_of.is_clear({5, 7, 4}, 4.99));
    EXPECT_FALSE(distance_of.is_clear({5, 7, 4}, 5.01));
}

TEST(PartDistance, OfACylinderIsToItsRadiusWithinTheTolerance)
{
    const Part part =
        std::vector<Surface>{nurbs_surface(test::cylinder(20, 4, 0.3, 2.3))};
    const PartCharts charts = part_charts(part);
    const PartDistance distance_of{charts, 0.01};
    std::optional<std::size_t> hint;
    const auto distance = [&](const Vec3& place) { return distance_of(place, hint); };
    EXPECT_GE(distance({2, 0, 25}), 5 - 1e-12);
    EXPECT_LE(distance({2, 0, 25}), 5.02);
    EXPECT_GE(distance({2, 0, 20}), 0);
    EXPECT_LE(distance({2, 0, 20}), 0.02);
}

TEST(PartDistance, FreeLengthsAreTheRadiiOfBallsThatFit)
{
    const Part box = test::box_mesh({0, 0, 0}, {2, 3, 4});
    const PartCharts charts = part_charts(box);
    const PartDistance in_box{charts, 0.1};
    std::optional<std::size_t> hint;
    const auto from_wall = [&](double height, double length) {
        return in_box.free_ball({{0, 1.5, height}, Vec3::UnitX(), length}, hint).length;
    };
    EXPECT_NEAR(from_wall(2, 100), 1, 1e-9);
    EXPECT_NEAR(from_wall(3.7, 100), 0.3, 1e-9);
    EXPECT_EQ(from_wall(3.7, 0.1), 0.1);
    EXPECT_NEAR(from_wall(4, 100), 0, 1e-9);
    EXPECT_EQ(in_box.free_ball({{0, 1.5, 2}, -Vec3::UnitX(), 100}, hint).length, 100);

    const auto low = in_box.free_ball({{0, 1.5, 3.7}, Vec3::UnitX(), 100}, hint);
    ASSERT_TRUE(low.other);
    EXPECT_NEAR((*low.other - Vec3(0.3, 1.5, 4)).norm(), 0, 1e-8);

    // The ball on the inside of a cylinder grows up to the axis.
    const Part part =
        std::vector<Surface>{nurbs_surface(test::cylinder(20, 4, 0.3, 2.3))};
    const PartCharts round = part_charts(part);
    const PartDistance in_cylinder{round, 0.001};
    std::optional<std::size_t> no_hint;
    const double free =
        in_cylinder.free_ball({{2, 0, 20}, -Vec3::UnitZ(), 100}, no_hint).length;
    EXPECT_LE(free, 20.1);
    EXPECT_GE(free, 19);
    EXPECT_EQ(in_cylinder.uncertainty() <= 0.002, true);
}

TEST(PartDistance, FindsPointsOverOrUnderThePart)
{
    const Part box = test::box_mesh({0, 0, 0}, {2, 3, 4});
    const PartCharts charts = part_charts(box);
    const PartDistance distance{charts, 0.1};
    EXPECT_TRUE(distance.is_over_or_under({1, 1.1, 9}));
    EXPECT_TRUE(distance.is_over_or_under({1, 1.1, 2}));
    EXPECT_TRUE(distance.is_over_or_under({1, 1.1, -9}));
    EXPECT_FALSE(distance.is_over_or_under({2.01, 1.1, 2}));
}

}  // namespace
}  // namespace endmill
