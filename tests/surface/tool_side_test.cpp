// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/tool_side.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

Surface plane_on_side(const Vec3& along_u, const Vec3& along_v, ToolSide side)
{
    std::array<test::Polynomial, 3> space;
    for (int c = 0; c < 3; ++c)
        space[c] = test::monomial(1, 0, along_u[c]) + test::monomial(0, 1, along_v[c]);
    return test::polynomial_surface(space, {{0, 1}, {0, 1}}, {1, 1}, side);
}

// A profile with slope dx/dt = b + (t - m)^2 and z = t: the wall is vertical where the
// slope is zero, and b slightly below zero gives a narrow overhang.
Surface profile(double m, double b, test::PatchCounts patches = {1, 1})
{
    const test::Polynomial x = test::monomial(1, 0, b + m * m) +
                               test::monomial(2, 0, -m) + test::monomial(3, 0, 1.0 / 3);
    return test::polynomial_surface({x, test::monomial(0, 1, 1), test::monomial(1, 0, 1)},
                                    {{0, 1}, {0, 1}}, patches);
}

TEST(ToolSide, UpIsTheSideOfTheAxis)
{
    const Vec3 x = 2 * Vec3::UnitX();
    const Vec3 y = 3 * Vec3::UnitY();
    EXPECT_EQ(tool_side_sign(plane_on_side(x, y, ToolSide::Up), Vec3::UnitZ()), 1);
    EXPECT_EQ(tool_side_sign(plane_on_side(y, x, ToolSide::Up), Vec3::UnitZ()), -1);
    EXPECT_EQ(tool_side_sign(plane_on_side(x, y, ToolSide::Up), -Vec3::UnitZ()), -1);
    EXPECT_EQ(tool_side_sign(plane_on_side(x, -y, ToolSide::Up), Vec3::UnitZ()), -1);
}

TEST(ToolSide, GivenByTheParametersDoesNotDependOnTheAxis)
{
    for (const Vec3& axis : {Vec3{0, 0, 1}, {0, 0, -1}, {1, 0, 0}}) {
        const Vec3 x = Vec3::UnitX();
        const Vec3 y = Vec3::UnitY();
        EXPECT_EQ(tool_side_sign(plane_on_side(x, y, ToolSide::DuCrossDv), axis), 1);
        EXPECT_EQ(tool_side_sign(plane_on_side(x, y, ToolSide::DvCrossDu), axis), -1);
    }
}

TEST(ToolSide, OfAWallAlongTheAxisIsThatOfItsParameters)
{
    const Surface wall = plane_on_side(Vec3::UnitX(), Vec3::UnitZ(), ToolSide::Up);
    EXPECT_EQ(tool_side_sign(wall, Vec3::UnitZ()), 1);
}

TEST(ToolSide, StaysInSpaceWhenTheSurfaceIsTransposed)
{
    for (const ToolSide side : {ToolSide::Up, ToolSide::DuCrossDv, ToolSide::DvCrossDu}) {
        const Surface surface =
            composite_bezier(2, 1, test::random_net(1, {2, 1}, 2), side);
        const auto normal = [](const Surface& of, double u, double v) -> Vec3 {
            return tool_side_sign(of, Vec3::UnitZ()) * unit_normal(of.tangents(u, v));
        };
        EXPECT_LT(
            (normal(surface, 1.3, 0.4) - normal(transposed(surface), 0.4, 1.3)).norm(),
            1e-13);
    }
}

TEST(UnreachablePlace, ThereIsNoneOnAGraphFromAbove)
{
    EXPECT_FALSE(find_unreachable_place(test::saddle(20, 30, {2, 2}), Vec3::UnitZ(), 1));
    EXPECT_FALSE(
        find_unreachable_place(test::parabolic_cylinder(1, 100, 10), Vec3::UnitZ(), 1));
}

TEST(UnreachablePlace, OnTheWrongSideIsEverywhere)
{
    const auto found = find_unreachable_place(test::plane(10, 10), Vec3::UnitZ(), -1);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->normal_dot_axis, -1);
}

TEST(UnreachablePlace, IsFoundOnAnOverhang)
{
    const Surface surface = profile(0.4, -0.04, {3, 2});
    const double side = tool_side_sign(surface, Vec3::UnitZ());
    const auto found = find_unreachable_place(surface, Vec3::UnitZ(), side);
    ASSERT_TRUE(found);
    EXPECT_LE(std::abs(found->at.u / 3 - 0.4), 0.2 + 1e-9) << "where dx/dt <= 0";
    ASSERT_TRUE(found->normal_dot_axis);
    EXPECT_LT(*found->normal_dot_axis, 1e-9);
    const SurfaceTangents tangents = surface.tangents(found->at.u, found->at.v);
    EXPECT_LT((found->point - tangents.point).norm(), 1e-13);
    EXPECT_NEAR(*found->normal_dot_axis, side * unit_normal(tangents).z(), 1e-12);
}

TEST(UnreachablePlace, IsFoundOnAnOverhangNarrowerThanAnySampling)
{
    test::Random random{1};
    for (int k = 0; k < 20; ++k) {
        // dx/dt < 0 over a width of 2e-3 at a random place.
        const double m = random.uniform(0.1, 0.9);
        EXPECT_TRUE(find_unreachable_place(profile(m, -1e-6), Vec3::UnitZ(), 1)) << m;
        EXPECT_FALSE(find_unreachable_place(profile(m, 1e-6), Vec3::UnitZ(), 1)) << m;
    }
}

TEST(UnreachablePlace, DownToTheStatedWidthOverhangsAreFound)
{
    test::Random random{2};
    for (int k = 0; k < 20; ++k) {
        const double half_width = 0x1p-14;
        const double m = random.uniform(0.1, 0.9);
        EXPECT_TRUE(find_unreachable_place(profile(m, -half_width * half_width),
                                           Vec3::UnitZ(), 1))
            << m;
    }
}

TEST(UnreachablePlace, IsFoundOnADimpleInTheMiddleOfAPatch)
{
    // Narrow in both parameters: dx/du = (u - 0.3)^2 + (v - 0.7)^2 + b.
    const auto dimple = [](double b) {
        const test::Polynomial x = test::monomial(3, 0, 1.0 / 3) +
                                   test::monomial(2, 0, -0.3) + test::monomial(1, 2, 1) +
                                   test::monomial(1, 1, -1.4) +
                                   test::monomial(1, 0, 0.09 + 0.49 + b);
        return test::polynomial_surface(
            {x, test::monomial(0, 1, 1), test::monomial(1, 0, 1)}, {{0, 1}, {0, 1}});
    };
    EXPECT_FALSE(find_unreachable_place(dimple(1e-7), Vec3::UnitZ(), 1));
    const auto found = find_unreachable_place(dimple(-1e-7), Vec3::UnitZ(), 1);
    ASSERT_TRUE(found);
    EXPECT_LE(std::hypot(found->at.u - 0.3, found->at.v - 0.7), 3.2e-4);
}

TEST(UnreachablePlace, IsAVerticalWall)
{
    const Surface wall = plane_on_side(Vec3::UnitX(), Vec3::UnitZ(), ToolSide::DvCrossDu);
    const auto found = find_unreachable_place(wall, Vec3::UnitZ(), -1);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->normal_dot_axis, 0);
    EXPECT_FALSE(find_unreachable_place(wall, -Vec3::UnitY(), 1));
}

TEST(UnreachablePlace, IsATangentVerticalAtABorderOnly)
{
    // z = sqrt(x) as (t^2, y, t) is vertical at t = 0 only.
    const Surface surface = test::polynomial_surface(
        {test::monomial(2, 0, 1), test::monomial(0, 1, 1), test::monomial(1, 0, 1)},
        {{0, 1}, {0, 1}});
    const auto found = find_unreachable_place(surface, Vec3::UnitZ(), 1);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->at.u, 0);
    ASSERT_TRUE(found->normal_dot_axis);
    EXPECT_NEAR(*found->normal_dot_axis, 0, 1e-15);
}

// (x, x y, height(x, y)) + pole for 0 <= x, y <= 1: the edge x = 0 collapses.
Surface fan(const test::Polynomial& height, const Vec3& pole)
{
    return test::polynomial_surface(
        {test::monomial(1, 0, 1) + test::monomial(0, 0, pole.x()),
         test::monomial(1, 1, 1) + test::monomial(0, 0, pole.y()),
         height + test::monomial(0, 0, pole.z())},
        {{0, 1}, {0, 1}}, {2, 2});
}

TEST(UnreachablePlace, IsNoPoleWhoseNormalHasALimitOnTheToolsSide)
{
    for (const Vec3& pole : {Vec3{0, 0, 0}, {7.3, 11.1, 0.7}, {-100.1, 3.7, 33.3}}) {
        EXPECT_FALSE(
            find_unreachable_place(fan(test::monomial(0, 0, 0), pole), Vec3::UnitZ(), 1));
        EXPECT_FALSE(
            find_unreachable_place(fan(test::monomial(1, 2, 1), pole), Vec3::UnitZ(), 1));
        const auto turned_away =
            find_unreachable_place(fan(test::monomial(0, 0, 0), pole), Vec3::UnitZ(), -1);
        EXPECT_TRUE(turned_away);
    }
}

TEST(UnreachablePlace, IsAPoleWithItsNormalTurnedAway)
{
    // (x, x (y - 0.6 y^2), 0) folds back where 1 - 1.2 y < 0, down to the pole.
    const Surface folded = test::polynomial_surface(
        {test::monomial(1, 0, 1), test::monomial(1, 1, 1) + test::monomial(1, 2, -0.6),
         test::monomial(0, 0, 0)},
        {{0, 1}, {0, 1}});
    const auto found = find_unreachable_place(folded, Vec3::UnitZ(), 1);
    ASSERT_TRUE(found);
    EXPECT_GE(found->at.v, 1 / 1.2 - 1e-3);
}

TEST(UnreachablePlace, IsACuspInTheMiddle)
{
    // (x^3, y, 0) has no tangent along x = 0.
    const Surface cusp = test::polynomial_surface(
        {test::monomial(3, 0, 1), test::monomial(0, 1, 1), test::monomial(0, 0, 0)},
        {{-1, 1}, {0, 1}});
    const auto found = find_unreachable_place(cusp, Vec3::UnitZ(), 1);
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->normal_dot_axis);
    EXPECT_NEAR(found->at.u, 0.5, 1e-5);
}

TEST(UnreachablePlace, DoesNotDependOnTheSizeOfThePart)
{
    for (const double scale : {1e-6, 1.0, 1e6}) {
        const Vec3 x{scale, 0, 0};
        const Vec3 y{0, scale, 0};
        EXPECT_FALSE(find_unreachable_place(test::parallelogram(x, y), Vec3::UnitZ(), 1));
        const Vec3 steep{0, 1e-9 * scale, scale};
        EXPECT_FALSE(
            find_unreachable_place(test::parallelogram(x, steep), Vec3::UnitZ(), 1));
    }
}

TEST(RequireReachable, NamesThePlace)
{
    EXPECT_NO_THROW(require_reachable(test::plane(10, 10), Vec3::UnitZ(), 1));
    try {
        require_reachable(test::plane(10, 10), Vec3::UnitZ(), -1);
        FAIL() << "expected a GeometryError";
    } catch (const GeometryError& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("u = 0, v = 0 (0, 0, 0 mm)"), std::string::npos)
            << message;
        EXPECT_NE(message.find("normal . axis = -1"), std::string::npos) << message;
    }
}

TEST(RequireReachable, NamesAPlaceWithoutANormalAsSuch)
{
    const Surface point = composite_bezier(1, 1, std::vector<Vec3>(16, Vec3{1, 2, 3}));
    try {
        require_reachable(point, Vec3::UnitZ(), 1);
        FAIL() << "expected a GeometryError";
    } catch (const GeometryError& error) {
        EXPECT_NE(std::string{error.what()}.find("no normal"), std::string::npos);
    }
}

}  // namespace
}  // namespace endmill
