// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/extent.h"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr double stated = 1e-9;

// Length of the curve z = bend x^2 / 2 from 0 to x.
double parabola_length(double bend, double x)
{
    const double slope = bend * x;
    return (slope * std::sqrt(1 + slope * slope) + std::asinh(slope)) / (2 * bend);
}

TEST(Area, OfAPlaneIsThatOfItsSides)
{
    EXPECT_LT(test::relative_error(area(test::plane(200, 120, {3, 2})), 24000), 1e-14);
    EXPECT_LT(test::relative_error(area(test::plane(1e-3, 1e3)), 1), 1e-14);
}

TEST(Area, OfAParallelogramIsTheCrossProductOfItsSides)
{
    const Vec3 along_u{200, 10, 30};
    const Vec3 along_v{60, 120, -20};
    EXPECT_LT(test::relative_error(area(test::parallelogram(along_u, along_v, {2, 3})),
                                   along_u.cross(along_v).norm()),
              1e-14);
}

TEST(Area, OfAParabolicCylinderIsItsArcTimesItsWidth)
{
    for (const double bend : {1e-4, 0.02, 0.5}) {
        const double expected = 2 * parabola_length(bend, 40) * 25;
        EXPECT_LT(
            test::relative_error(area(test::parabolic_cylinder(bend, 40, 25)), expected),
            stated)
            << bend;
    }
}

// Over a disc z = (x^2 - y^2) / (2 c) has an elementary area, over a square it has not.
// Simpson's rule on a grid converges with the fourth power.
double simpson(double c, double half, int steps)
{
    const double h = 2 * half / steps;
    double sum = 0;
    for (int j = 0; j <= steps; ++j)
        for (int i = 0; i <= steps; ++i) {
            const auto weight = [&](int k) {
                return k == 0 || k == steps ? 1 : k % 2 == 1 ? 4 : 2;
            };
            const double x = -half + i * h;
            const double y = -half + j * h;
            sum += weight(i) * weight(j) * std::sqrt(1 + (x * x + y * y) / (c * c));
        }
    return sum * h * h / 9;
}

TEST(Area, IsTheLimitThatSimpsonsRuleTendsTo)
{
    const double found = area(test::saddle(20, 30, {2, 1}));
    const double coarse = simpson(20, 30, 16) - found;
    const double fine = simpson(20, 30, 32) - found;
    EXPECT_NEAR(coarse / fine, 16, 1.5) << "order four";
    EXPECT_LT(test::relative_error(simpson(20, 30, 512), found), stated);
}

TEST(Area, DoesNotDependOnTheDivisionIntoPatches)
{
    const double whole = area(test::saddle(20, 30));
    for (const test::PatchCounts patches : {test::PatchCounts{1, 4}, {3, 1}, {5, 5}})
        EXPECT_LT(test::relative_error(area(test::saddle(20, 30, patches)), whole),
                  stated);
}

TEST(Area, OfAFanThatStartsAtAPointIsThatOfTheTriangle)
{
    // (x, x y, 0) for 0 <= x, y <= 1: the edge x = 0 collapses and the area is 1/2.
    const Surface fan = test::polynomial_surface(
        {test::monomial(1, 0, 1), test::monomial(1, 1, 1), test::monomial(0, 0, 0)},
        {{0, 1}, {0, 1}});
    EXPECT_LT(test::relative_error(area(fan), 0.5), stated);
}

TEST(Area, OfAPointOrALineIsZero)
{
    EXPECT_EQ(area(composite_bezier(1, 1, std::vector<Vec3>(16, Vec3{1, 2, 3}))), 0);
    const Vec3 along{0.3, 0.7, 0.1};
    EXPECT_NEAR(area(test::parallelogram(along, 1.7 * along)), 0, 1e-12);
}

}  // namespace
}  // namespace endmill
