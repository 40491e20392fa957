// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/surface.h"

#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

bool are_equal(const SurfaceJet& a, const SurfaceJet& b)
{
    return a.point == b.point && a.du == b.du && a.dv == b.dv && a.duu == b.duu &&
           a.duv == b.duv && a.dvv == b.dvv;
}

test::Polynomial some_cubic()
{
    return test::monomial(3, 1, 2e-4) + test::monomial(2, 2, -3e-4) +
           test::monomial(1, 3, 1e-4) + test::monomial(0, 2, 0.02);
}

TEST(Surface, OfSeveralPatchesIsTheOnePolynomialThatTheyShare)
{
    const Surface surface = test::graph(some_cubic(), {{-3, 6}, {1, 5}}, {3, 2});
    for (double u = -0.25; u <= 3.25; u += 0.125)
        for (double v = -0.25; v <= 2.25; v += 0.125) {
            const double x = -3 + 3 * u;
            const double y = 1 + 2 * v;
            const SurfaceJet jet = surface.jet(u, v);
            EXPECT_NEAR(jet.point.x(), x, 1e-13);
            EXPECT_NEAR(jet.point.z(),
                        2e-4 * x * x * x * y - 3e-4 * x * x * y * y +
                            1e-4 * x * y * y * y + 0.02 * y * y,
                        1e-13);
            EXPECT_NEAR(jet.du.z(),
                        3 * (6e-4 * x * x * y - 6e-4 * x * y * y + 1e-4 * y * y * y),
                        1e-12);
            EXPECT_NEAR(jet.duv.z(), 6 * (6e-4 * x * x - 12e-4 * x * y + 3e-4 * y * y),
                        1e-12);
            EXPECT_NEAR(jet.dvv.z(), 4 * (-6e-4 * x * x + 6e-4 * x * y + 0.04), 1e-12);
        }
}

TEST(Surface, PartialsCountInTheWidthsOfItsPatches)
{
    std::vector<BezierPatch> patches;
    patches.reserve(2);
    for (int k = 0; k < 2; ++k)
        patches.emplace_back(test::polynomial_net(
            {test::monomial(1, 0, 1), test::monomial(0, 1, 1),
             test::monomial(2, 0, 1) + test::monomial(1, 1, 1)},
            {k == 0 ? Interval{2, 3} : Interval{3, 7}, {1, 1.5}}, {1, 1}));
    const Surface surface{{2, 3, 7}, {1, 1.5}, patches};
    for (const double u : {2.1, 2.9, 3.0, 5.0, 7.0}) {
        const SurfaceJet jet = surface.jet(u, 1.2);
        EXPECT_LT((jet.point - Vec3{u, 1.2, u * u + 1.2 * u}).norm(), 1e-13);
        EXPECT_LT((jet.du - Vec3{1, 0, 2 * u + 1.2}).norm(), 1e-13);
        EXPECT_LT((jet.dv - Vec3{0, 1, u}).norm(), 1e-13);
        EXPECT_LT((jet.duu - Vec3{0, 0, 2}).norm(), 1e-12);
        EXPECT_LT((jet.duv - Vec3{0, 0, 1}).norm(), 1e-12);
        EXPECT_LT(jet.dvv.norm(), 1e-11);
    }
}

TEST(Surface, ABorderBelongsToThePatchAboveIt)
{
    const Surface surface = test::random_surface(1, {3, 2});
    EXPECT_EQ(surface.patch_number(Parameter::U, -5), 0);
    EXPECT_EQ(surface.patch_number(Parameter::U, 0), 0);
    EXPECT_EQ(surface.patch_number(Parameter::U, std::nextafter(1, 0)), 0);
    EXPECT_EQ(surface.patch_number(Parameter::U, 1), 1);
    EXPECT_EQ(surface.patch_number(Parameter::U, 2), 2);
    EXPECT_EQ(surface.patch_number(Parameter::U, 3), 2);
    EXPECT_EQ(surface.patch_number(Parameter::U, 50), 2);
    EXPECT_EQ(surface.patch_number(Parameter::V, 1), 1);
    EXPECT_EQ(surface.patch_number(Parameter::V, 2), 1);
    EXPECT_TRUE(are_equal(surface.jet(1, 0.5), surface.jet_in_patch(1, 0, 1, 0.5)));
    EXPECT_FALSE(are_equal(surface.jet(1, 0.5), surface.jet_in_patch(0, 0, 1, 0.5)));
    EXPECT_EQ(surface.jet_in_patch(0, 0, 1, 0.5).point, surface.jet(1, 0.5).point);
}

TEST(Surface, BeyondItsEndsTheBorderPatchContinues)
{
    const Surface surface = test::random_surface(2, {2, 2});
    EXPECT_EQ(surface.jet(-0.25, 0.5).point, surface.patch(0, 0).jet(-0.25, 0.5).point);
    EXPECT_EQ(surface.jet(2.25, 1.5).point, surface.patch(1, 1).jet(1.25, 0.5).point);
    EXPECT_EQ(surface.tangents(0.5, 2.5).dv, surface.patch(0, 1).tangents(0.5, 1.5).dv);
}

TEST(Surface, TangentsAreTheStartOfTheJet)
{
    const Surface surface = test::random_surface(3, {2, 3});
    test::Random random{3};
    for (int k = 0; k < 100; ++k) {
        const double u = random.uniform(-0.2, 2.2);
        const double v = random.uniform(-0.2, 3.2);
        const SurfaceTangents tangents = surface.tangents(u, v);
        const SurfaceJet jet = surface.jet(u, v);
        EXPECT_LT((tangents.point - jet.point).norm(), 1e-12);
        EXPECT_LT((tangents.du - jet.du).norm(), 1e-11);
        EXPECT_LT((tangents.dv - jet.dv).norm(), 1e-11);
    }
}

TEST(Surface, TransposedTwiceIsTheSameToTheBit)
{
    const Surface surface = test::random_surface(4, {3, 2});
    const Surface turned = transposed(surface);
    EXPECT_EQ(turned.patches(Parameter::U), 2);
    EXPECT_EQ(turned.patches(Parameter::V), 3);
    EXPECT_EQ(turned.range(Parameter::V).high, 3);
    EXPECT_EQ(turned.diagonal(), surface.diagonal());
    const Surface back = transposed(turned);
    for (const double u : {0.0, 0.4, 1.0, 2.7, 3.0})
        for (const double v : {0.0, 0.6, 1.0, 2.0}) {
            EXPECT_TRUE(are_equal(back.jet(u, v), surface.jet(u, v)));
            const SurfaceJet jet = surface.jet(u, v);
            const SurfaceJet other = turned.jet(v, u);
            EXPECT_LT((other.point - jet.point).norm(), 1e-12);
            EXPECT_LT((other.du - jet.dv).norm(), 1e-11);
            EXPECT_LT((other.duu - jet.dvv).norm(), 1e-11);
        }
}

TEST(Surface, TransposedKeepsItsToolSideInSpace)
{
    const std::vector<Vec3> net = test::random_net(5, {1, 1}, 1);
    const auto side_after = [&](ToolSide side) {
        return transposed(composite_bezier(1, 1, net, side)).tool_side();
    };
    EXPECT_EQ(side_after(ToolSide::Up), ToolSide::Up);
    EXPECT_EQ(side_after(ToolSide::DuCrossDv), ToolSide::DvCrossDu);
    EXPECT_EQ(side_after(ToolSide::DvCrossDu), ToolSide::DuCrossDv);
}

TEST(Surface, DiagonalIsThatOfTheBoxAroundItsNet)
{
    EXPECT_DOUBLE_EQ(test::plane(30, 40).diagonal(), 50);
    EXPECT_DOUBLE_EQ(test::parallelogram({2, 0, 0}, {0, 3, 6}).diagonal(), 7);
    const std::vector<Vec3> point(16, Vec3{5, 6, 7});
    EXPECT_EQ(composite_bezier(1, 1, point).diagonal(), 0);
}

TEST(Surface, RefusesSizesThatDisagree)
{
    const BezierPatch patch = test::plane(1, 1).patch(0, 0);
    EXPECT_THROW((Surface{{}, {}, {}}), DomainError);
    EXPECT_THROW((Surface{{0}, {0, 1}, {}}), DomainError);
    EXPECT_THROW((Surface{{0, 1}, {0, 1}, {}}), DomainError);
    EXPECT_THROW((Surface{{0, 1}, {0, 1}, {patch, patch}}), DomainError);
}

TEST(Surface, RefusesBreaksThatDoNotRise)
{
    const BezierPatch patch = test::plane(1, 1).patch(0, 0);
    for (const double second : {0.0, -1.0, nan})
        EXPECT_THROW((Surface{{0, second}, {0, 1}, {patch}}), DomainError) << second;
    EXPECT_THROW((Surface{{0, 1}, {nan, 1}, {patch}}), DomainError);
}

TEST(CompositeBezier, SharesTheBordersOfItsPatches)
{
    const Surface surface = test::random_surface(6, {3, 2});
    for (int k = 0; k < 4; ++k) {
        EXPECT_EQ(surface.patch(0, 1).control_point(3, k),
                  surface.patch(1, 1).control_point(0, k));
        EXPECT_EQ(surface.patch(2, 0).control_point(k, 3),
                  surface.patch(2, 1).control_point(k, 0));
    }
}

TEST(CompositeBezier, RefusesWrongCountsAndSizes)
{
    const std::vector<Vec3> net(28, Vec3::Zero());
    EXPECT_NO_THROW(composite_bezier(2, 1, net));
    EXPECT_NO_THROW(composite_bezier(1, 2, net));
    EXPECT_THROW(composite_bezier(1, 1, net), DomainError);
    EXPECT_THROW(composite_bezier(0, 1, net), DomainError);
    EXPECT_THROW(composite_bezier(2, -1, net), DomainError);
    EXPECT_THROW(composite_bezier(2, 1, std::vector<Vec3>(27, Vec3::Zero())),
                 DomainError);
    EXPECT_THROW(composite_bezier(1 << 30, 1 << 30, net), DomainError);
    EXPECT_THROW(composite_bezier(2, 1, std::vector<Vec3>(28, Vec3{0, nan, 0})),
                 DomainError);
}

TEST(Surface, HasTheWidthOfThePatchOfAParameter)
{
    const BezierPatch patch = test::plane(1, 1).patch(0, 0);
    const Surface surface{{-1, 0.5, 4}, {0, 2}, {patch, patch}};
    for (const double u : {-9.0, -1.0, 0.4})
        EXPECT_EQ(surface.patch_width(Parameter::U, u), 1.5);
    for (const double u : {0.5, 4.0, 9.0})
        EXPECT_EQ(surface.patch_width(Parameter::U, u), 3.5);
    EXPECT_EQ(surface.patch_width(Parameter::V, 1), 2);
}

TEST(Surface, ReversedIsTheSameWithUTurnedRound)
{
    const Surface even = test::random_surface(7, {2, 2});
    const Surface surface{
        {-1, 0.5, 4},
        {0, 1, 2},
        {even.patch(0, 0), even.patch(1, 0), even.patch(0, 1), even.patch(1, 1)},
        ToolSide::DuCrossDv};
    const Surface turned = reversed_in_u(surface);
    EXPECT_EQ(turned.tool_side(), ToolSide::DvCrossDu);
    EXPECT_EQ(turned.range(Parameter::U).low, -1);
    EXPECT_EQ(turned.breaks(Parameter::U)[1], 2.5);
    for (const double u : {-1.0, -0.2, 1.3, 4.0})
        for (const double v : {0.0, 0.7, 2.0}) {
            const SurfaceJet jet = surface.jet(u, v);
            const SurfaceJet other = turned.jet(3 - u, v);
            EXPECT_LT((other.point - jet.point).norm(), 1e-12);
            EXPECT_LT((other.du + jet.du).norm(), 1e-11);
            EXPECT_LT((other.dv - jet.dv).norm(), 1e-11);
            EXPECT_LT((other.duu - jet.duu).norm(), 1e-10);
            EXPECT_LT((other.duv + jet.duv).norm(), 1e-10);
        }
    EXPECT_TRUE(are_equal(reversed_in_u(turned).jet(0.9, 1.2), surface.jet(0.9, 1.2)));
    EXPECT_EQ(reversed_in_u(even).tool_side(), ToolSide::Up);
}

}  // namespace
}  // namespace endmill
