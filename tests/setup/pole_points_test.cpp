// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/pole_points.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "direction_sets.h"

namespace endmill {
namespace {

using test::degree;

TEST(PolePoints, ReadAzimuthAndPolarAngleAboutZ)
{
    const std::vector<test::AzimuthPolar> places{
        {0, 30}, {77, 90}, {179, 170}, {-100, 1e-7}};
    const PolePoints points{test::up, test::directions(places)};
    for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_NEAR(points.azimuth(i), places[i].azimuth * degree, 1e-8);
        EXPECT_NEAR(points.polar(i), places[i].polar * degree, 1e-15);
    }
    EXPECT_EQ(points.size(), places.size());
}

TEST(PolePoints, HaveARightHandedFrameAboutAnyToolAxis)
{
    test::Random random{3};
    for (int i = 0; i < 100; ++i) {
        const Vec3 axis =
            test::direction({random.uniform(0, 360), random.uniform(0, 180)});
        const PoleFrame frame{axis};
        EXPECT_NEAR(frame.x.cross(frame.y).dot(axis), 1, 1e-15);
        EXPECT_NEAR(frame.x.norm(), 1, 1e-15);
        EXPECT_NEAR(frame.equator(1).dot(frame.x), std::cos(1), 1e-15);
        EXPECT_NEAR(frame.equator(1).dot(frame.y), std::sin(1), 1e-15);
    }
}

TEST(PolePoints, BringAnglesIntoOneTurn)
{
    for (const double angle : {-7.0, -1e-3, 0.0, 3.0, 6.2, 6.3, 20.0}) {
        const double found = full_turn(angle);
        EXPECT_GE(found, 0);
        EXPECT_LE(found, 360 * degree);
        EXPECT_NEAR(std::remainder(found - angle, 360 * degree), 0, 1e-14);
    }
}

}  // namespace
}  // namespace endmill
