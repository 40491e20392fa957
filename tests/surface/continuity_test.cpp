// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/continuity.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "test_surfaces.h"

namespace endmill {
namespace {

// Two neighbouring patches over 0 to 2 by 0 to 1, with the heights `left` and `right`.
Surface two_patches(const test::Polynomial& left, const test::Polynomial& right)
{
    std::vector<BezierPatch> patches;
    for (const auto* height : {&left, &right})
        patches.emplace_back(test::polynomial_net(
            {test::monomial(1, 0, 1), test::monomial(0, 1, 1), *height},
            {height == &left ? Interval{0, 1} : Interval{1, 2}, {0, 1}}, {1, 1}));
    return Surface{{0, 1, 2}, {0, 1}, patches};
}

TEST(Continuity, HasNames)
{
    EXPECT_EQ(continuity_name(Continuity::None), "none");
    EXPECT_EQ(continuity_name(Continuity::G0), "G0");
    EXPECT_EQ(continuity_name(Continuity::G1), "G1");
}

TEST(Continuity, OfOnePatchIsG1AndHasNoBreak)
{
    const Surface surface = test::random_surface(1);
    EXPECT_TRUE(border_breaks(surface).empty());
    const SurfaceContinuity whole = continuity(surface);
    EXPECT_EQ(whole.continuity, Continuity::G1);
    EXPECT_EQ(whole.worst.normals.radians(), 0);
}

TEST(Continuity, OfOnePolynomialCutIntoPatchesIsG1)
{
    const Surface surface =
        test::graph(test::monomial(3, 2, 0.2) + test::monomial(1, 3, -0.4),
                    {{-1, 2}, {-2, 1}}, {3, 4});
    EXPECT_EQ(border_breaks(surface).size(), 2U * 4 + 3U * 3);
    const SurfaceContinuity whole = continuity(surface);
    EXPECT_EQ(whole.continuity, Continuity::G1);
    EXPECT_LT(whole.worst.normals.radians(), 1e-13);
    EXPECT_LT(whole.worst.gap_mm, 1e-14);
}

// A G1 net with unequal derivatives: beyond the border, the last column of the left patch
// is mirrored, with lambda times the step. [KimChoi, fig. 11]
TEST(Continuity, UnderTheConditionOfThePaperIsG1ButNotC1)
{
    for (const double lambda : {0.2, 1.0, 3.0}) {
        std::vector<Vec3> net = test::random_net(7, {2, 1}, 4);
        for (int row = 0; row < 4; ++row) {
            const Vec3 border = net[7 * row + 3];
            net[7 * row + 4] = border + lambda * (border - net[7 * row + 2]);
        }
        const Surface surface = composite_bezier(2, 1, net);
        EXPECT_EQ(continuity(surface).continuity, Continuity::G1) << lambda;
        const Vec3 left = surface.jet_in_patch(0, 0, 1, 0.3).du;
        const Vec3 right = surface.jet_in_patch(1, 0, 1, 0.3).du;
        EXPECT_LT((right - lambda * left).norm(), 1e-12);
    }
}

TEST(Continuity, OfAValleyIsG0AtTwiceItsSlope)
{
    for (const double slope : {1e-3, 0.2, 1.0, 5.0}) {
        const SurfaceContinuity whole = continuity(test::valley(50, 30, slope));
        EXPECT_EQ(whole.continuity, Continuity::G0);
        EXPECT_EQ(whole.worst.continuity, Continuity::G0);
        EXPECT_NEAR(whole.worst.normals.radians(), 2 * std::atan(slope), 1e-14);
        EXPECT_EQ(whole.worst.at.u, 1);
        EXPECT_NEAR(whole.worst.point.x(), 0, 1e-14);
        EXPECT_EQ(whole.worst.gap_mm, 0);
    }
}

TEST(Continuity, FindsTheWorstPlaceOfABreakThatOpensAlongTheBorder)
{
    // Beyond x = 1 the slope across the border is y^2: the break is widest at y = 1.
    const Surface surface = two_patches(
        test::monomial(0, 0, 0), test::monomial(1, 2, 1) + test::monomial(0, 2, -1));
    const std::vector<BorderBreak> breaks = border_breaks(surface);
    ASSERT_EQ(breaks.size(), 1U);
    EXPECT_EQ(breaks[0].continuity, Continuity::G0);
    EXPECT_EQ(breaks[0].at.u, 1);
    EXPECT_EQ(breaks[0].at.v, 1);
    EXPECT_LT((breaks[0].point - Vec3{1, 1, 0}).norm(), 1e-14);
    EXPECT_NEAR(breaks[0].normals.radians(), std::numbers::pi / 4, 1e-14);
}

TEST(Continuity, ChangesFromG1ToG0AtAMicroradian)
{
    const auto broken_by = [](double angle) {
        const double slope = std::tan(angle);
        return continuity(
            two_patches(test::monomial(0, 0, 0),
                        test::monomial(1, 0, slope) + test::monomial(0, 0, -slope)));
    };
    EXPECT_EQ(broken_by(0.9e-6).continuity, Continuity::G1);
    EXPECT_EQ(broken_by(1.1e-6).continuity, Continuity::G0);
    EXPECT_LT(test::relative_error(broken_by(0.9e-6).worst.normals.radians(), 0.9e-6),
              1e-8);
}

TEST(Continuity, DistinguishesAGapFromRounding)
{
    const auto apart = [](double gap) {
        const Surface surface =
            two_patches(test::monomial(0, 0, 0), test::monomial(0, 0, gap));
        return border_breaks(surface)[0];
    };
    const double size = std::sqrt(5.0);
    EXPECT_EQ(apart(0.9e-9 * size).continuity, Continuity::G1);
    const BorderBreak broken = apart(1.1e-9 * size);
    EXPECT_EQ(broken.continuity, Continuity::None);
    EXPECT_NEAR(broken.gap_mm, 1.1e-9 * size, 1e-20);
}

TEST(Continuity, OfAStepReportsTheStepAsItsWorstBreak)
{
    // The planes z = 0 and z = 1/4: their normals are equal, but there is a gap.
    const SurfaceContinuity whole =
        continuity(two_patches(test::monomial(0, 0, 0), test::monomial(0, 0, 0.25)));
    EXPECT_EQ(whole.continuity, Continuity::None);
    EXPECT_EQ(whole.worst.continuity, Continuity::None);
    EXPECT_NEAR(whole.worst.gap_mm, 0.25, 1e-15);
    EXPECT_EQ(whole.worst.at.u, 1);
}

TEST(Continuity, OfAMixedSurfaceListsEveryBorderAndKeepsTheLeast)
{
    // 3 by 2 patches over x: flat, flat, then rising with slope 1/2; constant along v.
    std::vector<Vec3> net;
    for (int row = 0; row < 7; ++row)
        for (int column = 0; column < 10; ++column)
            net.emplace_back(column, row, 0.5 * std::max(0, column - 6));
    const Surface surface = composite_bezier(3, 2, net);
    const std::vector<BorderBreak> breaks = border_breaks(surface);
    ASSERT_EQ(breaks.size(), 7U) << "2 by 2 across u, then 3 across v";
    for (const std::size_t smooth : {0, 1, 4, 5, 6})
        EXPECT_EQ(breaks[smooth].continuity, Continuity::G1) << smooth;
    for (const std::size_t broken : {2, 3}) {
        EXPECT_EQ(breaks[broken].continuity, Continuity::G0);
        EXPECT_EQ(breaks[broken].at.u, 2);
        EXPECT_NEAR(breaks[broken].normals.radians(), std::atan(0.5), 1e-14);
    }
    const SurfaceContinuity whole = continuity(surface);
    EXPECT_EQ(whole.continuity, Continuity::G0);
    EXPECT_EQ(whole.worst.at.u, 2);
}

TEST(Continuity, OfASurfaceThatFoldsBackIsNotSmooth)
{
    std::vector<Vec3> net;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 7; ++column)
            net.emplace_back(3 - std::abs(column - 3), row, 0);
    const SurfaceContinuity whole = continuity(composite_bezier(2, 1, net));
    EXPECT_EQ(whole.continuity, Continuity::G0);
    EXPECT_NEAR(whole.worst.normals.radians(), std::numbers::pi, 1e-14);
}

TEST(Continuity, SkipsSamplesWithoutANormal)
{
    // Two triangles that meet along x = 1 and have a common pole (0 ... 2, 0).
    std::vector<Vec3> net;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 7; ++column)
            net.emplace_back(1 + (column - 3) * row / 9.0, row / 3.0, 0);
    const SurfaceContinuity whole = continuity(composite_bezier(2, 1, net));
    EXPECT_EQ(whole.continuity, Continuity::G1);
    EXPECT_LT(whole.worst.normals.radians(), 1e-14);
}

}  // namespace
}  // namespace endmill
