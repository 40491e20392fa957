// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/cover_front.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "endmill/planning/path_interval.h"
#include "revolved_surfaces.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr double radius = 5;
constexpr double height = 0.4;
const BallCutter ball{radius};

TEST(CoverFront, OnAPlaneIsHalfTheInterval)
{
    const double interval = 2 * std::sqrt(2 * radius * height - height * height);
    const MarchedSurface plane{test::plane(40, 100), 1};
    const CoverFront front{plane, ball, height, Parameter::U};
    const PassSamples pass = front.samples(0.2);
    const std::vector<FrontPoint> points = front.front(pass, 0.01);
    for (std::size_t k = 0; k < points.size(); ++k) {
        EXPECT_NEAR(100 * (points[k].contact.v - 0.2), interval / 2, 1e-4);
        EXPECT_NEAR(points[k].foot_u, pass.u[k], 1e-3);
    }
    const double next = front.next_pass(0.2, points);
    EXPECT_NEAR(100 * (next - 0.2), interval, 3e-4 * interval);
    EXPECT_LE(100 * (next - 0.2), interval + 1e-4);
}

TEST(CoverFront, OnASkewedPlaneIsMeasuredAcrossThePass)
{
    const double interval = 2 * std::sqrt(2 * radius * height - height * height);
    const MarchedSurface plane{test::parallelogram({400, 0, 0}, {50, 100, 0}), 1};
    const CoverFront front{plane, ball, height, Parameter::U};
    const std::vector<FrontPoint> points = front.front(front.samples(0.5), 0.01);
    const FrontPoint& middle = points[points.size() / 2];
    EXPECT_NEAR(100 * (middle.contact.v - 0.5), interval / 2, 1e-3);
    EXPECT_NEAR(400 * (middle.foot_u - middle.contact.u), interval / 4, 0.1);
}

// [KimChoi, eq. (4)] is exact for passes along a cylinder, outside and inside.
TEST(CoverFront, OnACylinderIsTheIntervalOfTheClosedForm)
{
    constexpr double rho = 20;
    for (const double sign : {1.0, -1.0}) {
        const double middle = sign * std::numbers::pi / 2;
        const MarchedSurface marched{
            nurbs_surface(test::cylinder(rho, 30, middle - 0.7, middle + 0.7)), 1};
        MarchedSurface facing = marched;
        facing.side =
            contact_at(marched, {0.5, 0.5}, Parameter::U).contact.normal.z() > 0 ? 1 : -1;
        const CoverFront front{facing, ball, height, Parameter::U};
        const double v = 0.3;
        const double next = front.next_pass(v, front.front(front.samples(v), 0.01));
        const auto angle = [&](double at) {
            const Vec3 point = marched.surface.tangents(0.5, at).point;
            return std::atan2(point.z(), point.y());
        };
        const double expected = path_interval(ball, sign / rho, height).arc;
        EXPECT_NEAR(rho * std::abs(angle(next) - angle(v)), expected, 4e-4 * expected);
    }
}

TEST(CoverFront, EndsAtTheBorderWhereAPassReachesIt)
{
    const MarchedSurface plane{test::plane(40, 1), 1};
    const CoverFront front{plane, ball, height, Parameter::U};
    const std::vector<FrontPoint> points = front.front(front.samples(0), 0.01);
    for (const FrontPoint& point : points)
        EXPECT_EQ(point.contact.v, 1);
    EXPECT_EQ(front.next_pass(0, points), 1);
}

}  // namespace
}  // namespace endmill
