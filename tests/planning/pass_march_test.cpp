// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/pass_march.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/planning/iso_parametric.h"
#include "endmill/surface/tool_side.h"
#include "planned_path.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

// On a plane a ball of radius 5 leaves scallops of 1 mm at an interval of 6 mm.
IsoParametricOptions six_mm(Parameter direction = Parameter::U)
{
    IsoParametricOptions options;
    options.direction = direction;
    options.scallop_height = 1;
    return options;
}

// The surface for passes along u with the axis +z.
MarchedSurface upright(const Surface& surface)
{
    return {surface, tool_side_sign(surface, Vec3::UnitZ())};
}

MarchedPass march(const Surface& surface, double v, PassRole role)
{
    return march_pass(upright(surface), v, role, BallCutter{5}, six_mm());
}

TEST(MarchPass, OnAPlaneGoesFromEndToEndAndAllowsOneInterval)
{
    const MarchedPass pass =
        march(test::plane(200, 120, {3, 2}), 0.5, PassRole::Followed);
    ASSERT_EQ(pass.contacts.size(), 2U);
    EXPECT_EQ(pass.contacts[0].u, 0);
    EXPECT_EQ(pass.contacts[1].u, 3);
    EXPECT_EQ(pass.contacts[1].v, 0.5);
    EXPECT_LT((pass.contacts[1].contact.point - Vec3{200, 30, 0}).norm(), 1e-12);
    EXPECT_EQ(pass.contacts[0].contact.normal, Vec3::UnitZ());
    ASSERT_TRUE(pass.next);
    EXPECT_NEAR(pass.next->v, 0.5 + 6 * 2 / 120.0, 1e-12);
    ASSERT_TRUE(pass.next->governing);
    EXPECT_EQ(pass.next->governing->v, pass.next->v);
    EXPECT_EQ(pass.next->governing->at.v, 0.5);
    EXPECT_EQ(pass.next->governing->partner.v, pass.next->v);
}

TEST(MarchPass, ThatIsTheLastHasNoNextPass)
{
    EXPECT_FALSE(march(test::plane(200, 120), 1, PassRole::Last).next);
}

TEST(MarchPass, RisesAlongTheLineWithNormalsOnTheToolsSide)
{
    for (const Surface& surface :
         {test::saddle(40, 50, {2, 2}), transposed(test::saddle(40, 50, {2, 2}))}) {
        const MarchedPass pass = march(surface, 0.7, PassRole::Followed);
        ASSERT_GT(pass.contacts.size(), 3U);
        for (std::size_t k = 0; k < pass.contacts.size(); ++k) {
            EXPECT_GT(pass.contacts[k].contact.normal.z(), 0);
            if (k > 0) {
                EXPECT_GT(pass.contacts[k].u, pass.contacts[k - 1].u);
            }
        }
    }
}

TEST(MarchPass, WithoutALimitingContactHasAnInfiniteNextPass)
{
    // A trough of radius 5.2 mm at x = 0, little wider than the ball. All of its arc lies
    // within 0.5 mm of the ball.
    const Surface trough = transposed(test::parabolic_cylinder(1 / 5.2, 1e-3, 20));
    IsoParametricOptions options;
    options.scallop_height = 0.5;
    const MarchedPass pass =
        march_pass(upright(trough), 0.5, PassRole::Followed, BallCutter{5}, options);
    ASSERT_TRUE(pass.next);
    EXPECT_TRUE(std::isinf(pass.next->v));
    EXPECT_FALSE(pass.next->governing);
}

// (120 x, 60 x y, 0) + pole: the lines along u are rays from the point `pole`.
Surface fan(const Vec3& pole)
{
    return test::polynomial_surface(
        {test::monomial(1, 0, 120) + test::monomial(0, 0, pole.x()),
         test::monomial(1, 1, 60) + test::monomial(0, 0, pole.y()),
         test::monomial(0, 0, pole.z())},
        {{0, 1}, {0, 1}}, {2, 2});
}

TEST(MarchPass, OnACollapsedEdgeIsOnePointFromWhichPassesGoOn)
{
    for (const Vec3& pole : {Vec3{0, 0, 0}, {7.3, 11.1, 0.7}}) {
        const auto passes = test::passes_of(
            plan_iso_parametric(fan(pole), BallCutter{5}, six_mm(Parameter::V)).path);
        ASSERT_EQ(passes.size(), 21U) << "120 mm at 6 mm";
        ASSERT_EQ(passes[0].size(), 1U);
        EXPECT_LT((test::contact_point(passes[0][0]) - pole).norm(), 1e-13);
        EXPECT_LT((passes[0][0].contact()->contact.normal - Vec3::UnitZ()).norm(), 1e-12);
        for (std::size_t k = 1; k < passes.size(); ++k) {
            ASSERT_EQ(passes[k].size(), 2U);
            EXPECT_NEAR(test::contact_point(passes[k][0]).x() - pole.x(), 6.0 * double(k),
                        1e-8);
        }
    }
}

TEST(MarchPass, AlongRaysFromAPoleIsLimitedAtTheirFarEnd)
{
    for (const Vec3& pole : {Vec3{0, 0, 0}, {7.3, 11.1, 0.7}}) {
        const auto passes =
            test::passes_of(plan_iso_parametric(fan(pole), BallCutter{5}, six_mm()).path);
        double slope = 0;
        for (std::size_t n = 0; n + 1 < passes.size(); ++n) {
            ASSERT_EQ(passes[n].size(), 2U);
            const Vec3 end = test::contact_point(passes[n][n % 2 == 0 ? 1 : 0]) - pole;
            EXPECT_NEAR(end.y() / end.x(), slope, 1e-9) << n;
            // The next ray passes through the point 6 mm across this ray at its end.
            const double length = std::hypot(1, slope);
            slope = (120 * slope + 6 / length) / (120 - 6 * slope / length);
        }
        const Vec3 last = test::contact_point(passes.back()[0]) +
                          test::contact_point(passes.back()[1]) - 2 * pole;
        EXPECT_NEAR(last.y() / last.x(), 0.5, 1e-12) << "a pass on the border";
        EXPECT_GE(slope, 0.5);
    }
}

TEST(MarchPass, IsRefusedAtAPoleWithoutOneNormal)
{
    // (x, x y, x y^2 / 2): a cone, which has many normals at its apex.
    const Surface cone = test::polynomial_surface(
        {test::monomial(1, 0, 30), test::monomial(1, 1, 30), test::monomial(1, 2, 15)},
        {{0, 1}, {0, 1}});
    try {
        plan_iso_parametric(cone, BallCutter{1}, six_mm(Parameter::V));
        FAIL() << "expected a GeometryError";
    } catch (const GeometryError& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("no normal"), std::string::npos) << message;
        EXPECT_NE(message.find("u = 0"), std::string::npos) << message;
    }
    EXPECT_NO_THROW(plan_iso_parametric(cone, BallCutter{1}, six_mm(Parameter::U)))
        << "along a ray the normal has a limit";
}

}  // namespace
}  // namespace endmill
