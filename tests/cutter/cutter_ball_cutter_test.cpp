// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/cutter.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "random.h"

namespace endmill {
namespace {

TEST(BallCutter, RefusesRadiiThatAreNotPositive)
{
    for (const double radius : {0.0, -1.0, std::numeric_limits<double>::infinity(),
                                std::numeric_limits<double>::quiet_NaN()})
        EXPECT_THROW(BallCutter{radius}, DomainError) << radius;
    EXPECT_EQ(BallCutter{7.5}.radius(), 7.5);
}

// A ball of radius 5 on a sphere of radius 40; the vectors were computed with 50 digits.
TEST(Locate, OnASphereIsTheTabulatedTip)
{
    const BallCutter ball{5};
    const CutterLocation top = locate(ball, {{0, 0, 40}, Vec3::UnitZ()}, Vec3::UnitZ());
    EXPECT_EQ(top.tip, Vec3(0, 0, 40));
    EXPECT_EQ(top.axis, Vec3::UnitZ());
    const double half_root = std::sqrt(0.5);
    const CutterLocation side =
        locate(ball, {{28.2842712474619, 0, 28.2842712474619}, {half_root, 0, half_root}},
               Vec3::UnitZ());
    EXPECT_LT((side.tip - Vec3{31.8198051533946, 0, 26.8198051533946}).norm(), 1e-13);
}

TEST(Locate, PutsTheContactOnTheBallAndTheBallOnTheOuterSide)
{
    test::Random random{1};
    const auto direction = [&]() -> Vec3 {
        return Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}
            .normalized();
    };
    for (int k = 0; k < 1000; ++k) {
        const BallCutter ball{random.log_uniform(0.01, 100)};
        const Vec3 axis = direction();
        Vec3 normal = direction();
        if (normal.dot(axis) < 0)
            normal = -normal;
        const CutterContact contact{100 * direction(), normal};
        const CutterLocation location = locate(ball, contact, axis);
        const Vec3 centre = location.tip + ball.radius() * axis;
        EXPECT_NEAR((contact.point - centre).norm(), ball.radius(), 1e-13);
        EXPECT_LT(((contact.point - centre) / ball.radius() + normal).norm(), 1e-10);
        EXPECT_EQ(location.axis, axis);
        EXPECT_GE((contact.point - location.tip).dot(axis), -1e-13)
            << "no part of the ball is below its tip";
    }
}

TEST(Locate, RefusesAContactOnOrAboveTheEquator)
{
    const BallCutter ball{5};
    EXPECT_THROW(locate(ball, {Vec3::Zero(), Vec3::UnitX()}, Vec3::UnitZ()),
                 GeometryError);
    EXPECT_THROW(locate(ball, {Vec3::Zero(), -Vec3::UnitZ()}, Vec3::UnitZ()),
                 GeometryError);
    EXPECT_NO_THROW(locate(ball, {Vec3::Zero(), Vec3{1, 0, 1e-9}}, Vec3::UnitZ()));
}

}  // namespace
}  // namespace endmill
