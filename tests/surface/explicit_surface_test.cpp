// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/detail/explicit_surface.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

class GivenSurfaces : public testing::TestWithParam<HeightJet (*)(double, double)> {};

// Central differences with a step of 1e-4 mm have an error of about 1e-8.
TEST_P(GivenSurfaces, HaveThePartialsOfCentralDifferences)
{
    constexpr double step = 1e-4;
    const auto& surface = *GetParam();
    for (const double x : {-55.0, -20.0, 3.0, 41.0})
        for (const double y : {-19.0, -4.0, 0.5, 17.0}) {
            const HeightJet jet = surface(x, y);
            const HeightJet left = surface(x - step, y);
            const HeightJet right = surface(x + step, y);
            const HeightJet below = surface(x, y - step);
            const HeightJet above = surface(x, y + step);
            EXPECT_NEAR(jet.zx, (right.z - left.z) / (2 * step), 1e-7);
            EXPECT_NEAR(jet.zy, (above.z - below.z) / (2 * step), 1e-7);
            EXPECT_NEAR(jet.zxx, (right.zx - left.zx) / (2 * step), 1e-7);
            EXPECT_NEAR(jet.zxy, (above.zx - below.zx) / (2 * step), 1e-7);
            EXPECT_NEAR(jet.zyy, (above.zy - below.zy) / (2 * step), 1e-7);
        }
}

INSTANTIATE_TEST_SUITE_P(OfThePaperAndOurs, GivenSurfaces,
                         testing::Values(ball_end_test_surface, bicycle_saddle));

TEST(ExplicitSurface, OfThePaperHasAFourFoldSymmetry)
{
    for (const double x : {-50.0, 7.0, 33.0})
        for (const double y : {-38.0, 12.0})
            EXPECT_NEAR(ball_end_test_surface(x, y).z, ball_end_test_surface(-y, x).z,
                        1e-13);
}

TEST(ExplicitSurface, OfTheSaddleHasItsHeightsOnTheAxes)
{
    EXPECT_NEAR(bicycle_saddle(-90, 0).z, 10, 1e-12);
    EXPECT_NEAR(bicycle_saddle(0, 0).z, 0, 1e-12);
    EXPECT_NEAR(bicycle_saddle(-90, 15).z, 10 - 3 * (17 - 8), 1e-12)
        << "8, 15 and 17 are the sides of a right triangle";
}

HeightJet plane(double x, double y)
{
    return {3 * x + 4 * y + 1, 3, 4, 0, 0, 0};
}

TEST(SurfaceFacts, OfAPlaneAreThoseOfArithmetic)
{
    const XyRectangle extent{{0, 2}, {0, 1}};
    const SurfaceFacts facts = surface_facts(plane, extent, 1 + 6, 40);
    EXPECT_NEAR(facts.least_z_mm, 1, 1e-12);
    EXPECT_NEAR(facts.greatest_z_mm, 11, 1e-12);
    EXPECT_NEAR(facts.area_mm2, 2 * std::sqrt(26), 1e-12);
    EXPECT_NEAR(facts.steepest_deg, std::atan(5) * 180 / std::numbers::pi, 1e-10);
    // 3 x + 4 y > 6 holds on the triangle (2, 0), (2, 1), (2/3, 1) of 2/3 mm^2.
    EXPECT_NEAR(facts.share_above, 1.0 / 3, 0.02);
}

HeightJet dome(double x, double y)
{
    constexpr double radius = 10;
    const double z = std::sqrt(radius * radius - x * x - y * y);
    const double z3 = z * z * z;
    return {z, -x / z, -y / z, -(z * z + x * x) / z3, -x * y / z3, -(z * z + y * y) / z3};
}

TEST(SurfaceFacts, OfASphereHaveItsRadius)
{
    const SurfaceFacts facts = surface_facts(dome, {{-5, 5}, {-4, 4}}, 0, 20);
    EXPECT_NEAR(facts.least_radius_mm, 10, 1e-9);
    EXPECT_EQ(facts.share_above, 1);
}

TEST(ExplicitSurface, OfAGridInterpolatesTheNodes)
{
    const XyRectangle extent{{-60, 60}, {-40, 40}};
    const ExplicitSurface spline =
        explicit_surface(gridded(ball_end_test_surface, extent, 12, 8));
    for (int i = 0; i <= 12; ++i)
        for (int j = 0; j <= 8; ++j) {
            const double x = -60 + 10.0 * i;
            const double y = -40 + 10.0 * j;
            EXPECT_NEAR(spline(x, y).z, ball_end_test_surface(x, y).z, 1e-11);
        }
    EXPECT_THROW(gridded(ball_end_test_surface, extent, 0, 8), DomainError);
}

// A cubic spline has the order 4, so half the cells leave a sixteenth of the distance. Near the
// border the end conditions lower the order.
TEST(ExplicitSurface, OfFinerGridsApproachesTheSurface)
{
    const XyRectangle extent{{-60, 60}, {-40, 40}};
    double last = 0;
    for (const int cells : {12, 24, 48}) {
        const double distance = farthest_apart(
            explicit_surface(gridded(ball_end_test_surface, extent, cells, cells)),
            ball_end_test_surface, extent, 97);
        if (last > 0) {
            EXPECT_LT(distance, last / 4);
        }
        last = distance;
    }
}

}  // namespace
}  // namespace endmill
