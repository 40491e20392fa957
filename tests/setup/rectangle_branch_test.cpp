// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/rectangle_branch.h"

#include <gtest/gtest.h>

#include "direction_sets.h"
#include "endmill/machine/feasible_directions.h"
#include "endmill/setup/detail/rectangle_fit.h"

namespace endmill {
namespace {

using test::up;

// If all directions are within 90 degrees, the edges of the hulls give the exact minimum.
TEST(RectangleBranch, FindsTheMinimumOfTheHulls)
{
    test::Random random{41};
    for (int i = 0; i < 100; ++i) {
        const std::vector<Vec3> points = test::random_directions(random);
        const double exact =
            rectangle_fit(up, points, {RotaryFamily::AB, SetupMode::Corrected, {}})
                .least->area;
        const auto found = branch_rectangle(PolePoints{up, points}, {});
        ASSERT_TRUE(found);
        EXPECT_GE(found->area(), exact * (1 - 1e-12));
        EXPECT_LE(found->area(), exact * (1 + 1.1e-7));
        const auto coarse = coarse_rectangle(PolePoints{up, points}, {});
        EXPECT_GE(coarse->area(), exact * (1 - 1e-12));
    }
}

// Two directions lie 120 degrees from the tool axis; their alpha jumps where R1 has their
// azimuth. No position of R1 at a multiple of 0.01 degrees is better.
TEST(RectangleBranch, CrossesTheJumpsOfLowDirections)
{
    const std::vector<Vec3> points =
        test::directions({{90, 120}, {270, 120}, {0, 30}, {180, 10}});
    const auto found = branch_rectangle(PolePoints{up, points}, {});
    ASSERT_TRUE(found);
    double searched = 1e9;
    for (double azimuth = 0; azimuth < 180; azimuth += 0.01)
        searched = std::min(
            searched, rectangle_about(up, test::direction({azimuth, 90}), points).area());
    EXPECT_LE(found->area(), searched * (1 + 1.1e-7));
    EXPECT_LE(searched, found->area() * 1.002);
    EXPECT_NEAR(rectangle_about(up, found->r1_axis, points).area(), found->area(), 1e-9);
}

// A direction perpendicular to the tool axis, or nearly so, needs no turn about R1 if R1
// lies along it. No other position of R1, however close, has such a small rectangle. The
// alpha of this direction is 0, to 1e-9 rad, as in rectangle_about.
TEST(RectangleBranch, PutsR1AlongADirectionAtRightAnglesToTheToolAxis)
{
    for (const double polar : {90.0, 90 - 1e-8, 90 + 1e-8, 90 - 1e-5}) {
        for (const double azimuth : {0.0, 15.0, 123.4, 310.0}) {
            const std::vector<Vec3> points =
                test::directions({{azimuth, polar},
                                  {azimuth + 276.584, 72.372},
                                  {azimuth + 245.595, 75.133},
                                  {azimuth + 173.873, 26.202}});
            const double along =
                rectangle_about(up, test::direction({azimuth, 90}), points).area();
            double searched = 1e9;
            for (double turn = 0.005; turn < 180; turn += 0.01)
                searched = std::min(
                    searched,
                    rectangle_about(up, test::direction({azimuth + turn, 90}), points)
                        .area());
            ASSERT_LT(along, 0.87 * searched);
            const auto found = branch_rectangle(PolePoints{up, points}, {});
            ASSERT_TRUE(found);
            EXPECT_NEAR(found->area(), along, 1.1e-7 * along);
            EXPECT_NEAR(std::abs(found->r1_axis.dot(test::direction({azimuth, 90}))), 1,
                        1e-12);
        }
    }
}

// Directions on a lattice; many of them are perpendicular or opposite to the tool axis,
// or have the same azimuth. No position of R1 at a multiple of a quarter degree or along
// a direction is better, and the machine reaches all directions within the ranges found.
TEST(RectangleBranch, IsNotWorseThanAnyPositionOfR1)
{
    test::Random random{83};
    for (int i = 0; i < 400; ++i) {
        std::vector<test::AzimuthPolar> places{{0, 105}};
        const int count = 1 + i % 7;
        for (int k = 0; k < count; ++k)
            places.push_back({30 * std::floor(random.uniform(0, 12)),
                              15 * std::floor(random.uniform(1, i % 2 == 0 ? 7 : 13))});
        const std::vector<Vec3> points = test::directions(places);
        std::vector<double> azimuths;
        for (int k = 0; k < 720; ++k)
            azimuths.push_back(0.25 * k);
        for (const test::AzimuthPolar& place : places)
            azimuths.push_back(place.azimuth);
        double searched = 1e9;
        for (const double azimuth : azimuths)
            searched = std::min(
                searched,
                rectangle_about(up, test::direction({azimuth, 90}), points).area());
        const auto found = branch_rectangle(PolePoints{up, points}, {});
        ASSERT_TRUE(found);
        EXPECT_LE(found->area(), searched * (1 + 1.1e-7) + 1e-10) << i;
        const FeasibleDirections reached{
            {RotaryFamily::AB, up, found->r1_axis, up.cross(found->r1_axis)},
            {found->alpha, found->beta}};
        for (const Vec3& direction : points)
            EXPECT_TRUE(reached.contains(direction)) << i;
    }
}

// The opposite of the tool axis costs less on the side where alpha is larger. On that
// side neither this rectangle nor the one turned by 180 degrees fits the limits.
TEST(RectangleBranch, PutsTheOppositeOfTheToolAxisWhereTheLimitsHaveRoom)
{
    const std::vector<Vec3> points{test::turned_to(10, 20), test::turned_to(-5, 1), -up};
    BranchGoal goal;
    goal.limits = RotaryLimits{{-180 * test::degree, 12 * test::degree},
                               {-2 * test::degree, 22 * test::degree}};
    const auto found = branch_rectangle(PolePoints{up, points}, goal);
    ASSERT_TRUE(found);
    EXPECT_TRUE(fits_rigidly(*found, *goal.limits));
    EXPECT_LE(test::square_degrees(found->area()), 190 * 20 * (1 + 1.1e-7));
    const FeasibleDirections reached{
        {RotaryFamily::AB, up, found->r1_axis, up.cross(found->r1_axis)},
        {found->alpha, found->beta}};
    for (const Vec3& direction : points)
        EXPECT_TRUE(reached.contains(direction));
}

TEST(RectangleBranch, FindsNothingAboveTheGoalOrOutsideTheLimits)
{
    const std::vector<Vec3> points = test::directions({{90, 120}, {270, 120}, {0, 30}});
    const double area = branch_rectangle(PolePoints{up, points}, {})->area();
    BranchGoal goal;
    goal.worthless = 0.99 * area;
    EXPECT_FALSE(branch_rectangle(PolePoints{up, points}, goal));
    goal.worthless = 1.01 * area;
    EXPECT_TRUE(branch_rectangle(PolePoints{up, points}, goal));
    goal.limits = RotaryLimits{{-0.5, 0.5}, {-0.5, 0.5}};
    EXPECT_FALSE(branch_rectangle(PolePoints{up, points}, goal));
}

}  // namespace
}  // namespace endmill
