// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/plane_offset.h"

#include <cmath>

#include <gtest/gtest.h>

namespace endmill {
namespace {

using Vec2 = Eigen::Vector2d;

// Samples of z = bend x^2 / 2 from x = -half to half, in 2 n steps.
std::vector<ProfilePoint> parabola(double bend, double half, int n)
{
    std::vector<ProfilePoint> profile;
    for (int k = -n; k <= n; ++k) {
        const double x = half * k / n;
        profile.push_back({{x, bend * x * x / 2}, profile_normal(bend * x)});
    }
    return profile;
}

TEST(PlaneOffset, NormalIsPerpendicularToTheTangentAndPointsUp)
{
    for (const double slope : {-1e200, -3.0, -0.2, 0.0, 1.0, 1e200}) {
        const Vec2 normal = profile_normal(slope);
        EXPECT_NEAR(normal.norm(), 1, 1e-15);
        EXPECT_GE(normal.y(), 0);
        EXPECT_NEAR(normal.dot(Vec2{1, slope}.stableNormalized()), 0, 1e-15);
        EXPECT_LE((curve_normal({1, slope}) - normal).norm(), 1e-15);
        EXPECT_LE((curve_normal({-1, -slope}) - normal).norm(), 1e-15);
    }
    EXPECT_EQ(curve_normal({0, 5}), Vec2(-1, 0));
}

// The offset of z = x^2 / (2 p) for a ball has cusps at |x| = p ((R/p)^(2/3) - 1)^(3/2).
TEST(PlaneOffset, OfAParabolaForABallHasTheCuspsOfTheClosedForm)
{
    const auto offset = plane_offset(Cutter::ball(10), parabola(1.0 / 6, 16, 20000));
    double farthest_back = 0;  // end of the tail that runs back over x = 0
    for (std::size_t k = 0; k < offset.size() / 2; ++k)
        farthest_back = std::max(farthest_back, offset[k].x());
    EXPECT_NEAR(farthest_back, 1.550574566060, 1e-6);
    EXPECT_EQ(offset.size(), 40001U);
}

// The offset of a circular ridge is a circle, divided by the flat bottom.
TEST(PlaneOffset, OfACircularRidgeIsTwoArcsAndALinkForwards)
{
    const Cutter cutter{4, 1};
    std::vector<ProfilePoint> ridge;
    for (int k = -10; k <= 10; ++k) {
        const Vec2 normal{std::sin(0.1 * k), std::cos(0.1 * k)};
        ridge.push_back({20 * normal, normal});
    }
    const auto offset = plane_offset(cutter, ridge);
    ASSERT_EQ(offset.size(), ridge.size() + 1);
    for (std::size_t k = 0; k < offset.size(); ++k) {
        const double middle = k <= 10 ? -3 : 3;
        EXPECT_NEAR((offset[k] - Vec2{middle, 0}).norm(), 21, 1e-13);
    }
    EXPECT_NEAR(offset[11].x() - offset[10].x(), 6, 1e-13);
    EXPECT_EQ(offset[11].y(), offset[10].y());
}

TEST(PlaneOffset, OfAnyValleyForAFlatBottomHasALinkBackwards)
{
    const auto offset = plane_offset(Cutter{2, 0.5}, parabola(1e-3, 10, 10));
    ASSERT_EQ(offset.size(), 22U);
    EXPECT_NEAR(offset[11].x() - offset[10].x(), -3, 1e-13);
    EXPECT_EQ(plane_offset(Cutter::ball(2), parabola(1e-3, 10, 10)).size(), 21U);
}

// The side changes at the end of a level part, or at the first point of the other side if
// no point is level.
TEST(PlaneOffset, LinksAtTheEndOfALevelStretch)
{
    const Cutter flat = Cutter::flat(1);
    const std::vector<ProfilePoint> terrace{{{0, 0}, profile_normal(1)},
                                            {{1, 1}, {0, 1}},
                                            {{2, 1}, {0, 1}},
                                            {{3, 1}, {0, 1}},
                                            {{4, 0}, profile_normal(-1)}};
    const auto offset = plane_offset(flat, terrace);
    const std::vector<Vec2> expected{{-1, 0}, {0, 1}, {1, 1}, {2, 1}, {4, 1}, {5, 0}};
    EXPECT_EQ(offset, expected);
    const std::vector<ProfilePoint> sharp{{{0, 0}, profile_normal(1)},
                                          {{1, 0}, profile_normal(-1)}};
    EXPECT_EQ(plane_offset(flat, sharp), (std::vector<Vec2>{{-1, 0}, {0, 0}, {2, 0}}));
}

TEST(PlaneOffset, AtALevelEndTakesTheSideOfTheRest)
{
    const Cutter flat = Cutter::flat(1);
    const std::vector<ProfilePoint> profile{
        {{0, 0}, {0, 1}}, {{1, 0}, {0, 1}}, {{2, -1}, profile_normal(-1)}};
    EXPECT_EQ(plane_offset(flat, profile), (std::vector<Vec2>{{1, 0}, {2, 0}, {3, -1}}));
    const std::vector<ProfilePoint> level{{{0, 0}, {0, 1}}, {{1, 0}, {0, 1}}};
    EXPECT_EQ(plane_offset(Cutter{2, 1}, level), (std::vector<Vec2>{{0, 1}, {1, 1}}));
    EXPECT_TRUE(plane_offset(flat, {}).empty());
}

// A roof |x|, sampled with the mean of its slopes at the ridge: two chords close the gap.
TEST(PlaneOffset, AtACreaseTheMeanOfTheSlopesClosesTheGap)
{
    EXPECT_EQ(crease_normal(1, -1), Vec2(0, 1));
    EXPECT_LE((crease_normal(0.5, 1.5) - profile_normal(1)).norm(), 1e-16);
    const std::vector<ProfilePoint> roof{{{-1, -1}, profile_normal(1)},
                                         {{0, 0}, crease_normal(1, -1)},
                                         {{1, -1}, profile_normal(-1)}};
    const auto offset = plane_offset(Cutter::ball(2), roof);
    ASSERT_EQ(offset.size(), 3U);
    EXPECT_EQ(offset[1], Vec2(0, 2));
    EXPECT_LT(offset[0].x(), offset[1].x());
    EXPECT_LT(offset[1].x(), offset[2].x());
}

}  // namespace
}  // namespace endmill
