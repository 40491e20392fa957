// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/scallop_between.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "endmill/surface/nurbs.h"
#include "endmill/surface/tool_side.h"
#include "revolved_surfaces.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

double scallop(const Surface& surface, const BallCutter& ball, const SurfacePoint& one,
               const SurfacePoint& other)
{
    const double side = tool_side_sign(surface, Vec3::UnitZ());
    const FeedFrame frame = feed_frame(one, surface.jet(one.u, one.v), side);
    return scallop_between(surface, ball, frame, other, side);
}

TEST(ScallopBetween, BallsOnAPlaneHasThePlaneCusp)
{
    const Surface plane = test::plane(20, 10);
    for (const double apart : {1.0, 3.0, 6.0})
        EXPECT_NEAR(scallop(plane, BallCutter{5}, {0.5, 0.2}, {0.5, 0.2 + apart / 10}),
                    5 - std::sqrt(25 - apart * apart / 4), 1e-12);
}

TEST(ScallopBetween, BallsThatDoNotMeetIsNoNumber)
{
    EXPECT_TRUE(
        std::isnan(scallop(test::plane(20, 20), BallCutter{2}, {0.5, 0}, {0.5, 1})));
}

// Two balls outside a cylinder of radius 20, at an angle t from each other: the cusp lies on the
// bisector, at (20 + R) cos(t / 2) - sqrt(R^2 - (20 + R)^2 sin^2(t / 2)) from the axis.
TEST(ScallopBetween, BallsOnACylinderHasTheCuspOfTheTriangle)
{
    const double from = 1;
    const double to = 2;
    const Surface cylinder = nurbs_surface(test::cylinder(20, 10, from, to));
    const auto angle_at = [&](double v) {
        const Vec3 point = cylinder.tangents(0.5, v).point;
        return std::atan2(point.z(), point.y());
    };
    const double v = 0.7;
    const double t = std::abs(angle_at(v) - angle_at(0.5));
    const double centre = 25;
    const double across = centre * std::sin(t / 2);
    const double cusp = centre * std::cos(t / 2) - std::sqrt(25 - across * across);
    EXPECT_NEAR(scallop(cylinder, BallCutter{5}, {0.5, 0.5}, {0.5, v}), cusp - 20, 1e-10);
}

// The interval is exact on a plane, so each pass leaves the scallop height asked for, except the
// last one, which is forced onto the border.
TEST(GoverningScallops, OnAPlaneAreTheScallopHeight)
{
    const Surface plane = test::plane(30, 20);
    IsoParametricOptions options;
    options.scallop_height = 0.4;
    for (const Parameter direction : {Parameter::U, Parameter::V}) {
        options.direction = direction;
        const BallCutter ball{6};
        const auto scallops = governing_scallops(
            plane, ball, plan_iso_parametric(plane, ball, options), direction);
        ASSERT_GE(scallops.size(), 3U);
        for (const double height : scallops)
            EXPECT_NEAR(height, 0.4, 1e-9);
    }
}

}  // namespace
}  // namespace endmill
