// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/plane_offset.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

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

double distance_to_segment(const Vec2& point, const Vec2& a, const Vec2& b)
{
    const double share =
        std::clamp((point - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    return (point - a - share * (b - a)).norm();
}

double distance_to(const std::vector<Vec2>& polyline, const Vec2& point)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < polyline.size(); ++i)
        nearest =
            std::min(nearest, distance_to_segment(point, polyline[i], polyline[i + 1]));
    return nearest;
}

// A right-angled ridge: the ball's centre follows two lines, a quarter circle about the
// corner and, at the ends, arcs down to the height of the ends.
TEST(PolylineOffset, RollsAroundAConvexCorner)
{
    const std::vector<Vec2> ridge{{-4, -4}, {0, 0}, {4, -4}};
    const PolylineOffset offset = polyline_offset(Cutter::ball(2), ridge);
    for (std::size_t i = 0; i < offset.points.size(); ++i) {
        EXPECT_NEAR(distance_to(ridge, offset.points[i]), 2, 1e-14);
        if (i == 0)
            continue;
        const Vec2 middle = (offset.points[i - 1] + offset.points[i]) / 2;
        EXPECT_GE(distance_to(ridge, middle), 2 - 1.25e-4);
    }
    EXPECT_LE((offset.points.front() - Vec2{-6, -4}).norm(), 1e-14);
    EXPECT_LE((offset.points.back() - Vec2{6, -4}).norm(), 1e-14);
    EXPECT_NE(std::ranges::find(offset.points, Vec2(0, 2)), offset.points.end());
    EXPECT_NEAR(offset.low_s, -4 - std::sqrt(2), 1e-14);
    EXPECT_NEAR(offset.high_s, 4 + std::sqrt(2), 1e-14);
}

TEST(PolylineOffset, AsPrintedJoinsTheOffsetsOfSegmentsByChords)
{
    const std::vector<Vec2> ridge{{-4, -4}, {0, 0}, {4, -4}};
    const PolylineOffset offset = polyline_offset(Cutter::ball(std::sqrt(2)), ridge,
                                                  {.rolls_around_corners = false});
    const std::vector<Vec2> expected{{-5, -3}, {-1, 1}, {1, 1}, {5, -3}};
    ASSERT_EQ(offset.points.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_LE((offset.points[i] - expected[i]).norm(), 1e-14);
}

// The flat bottom touches the left wall of a valley with its left rim, the right wall with
// its right rim, so that the offset crosses itself in (0, 1).
TEST(PolylineOffset, OfAValleyForAFlatBottomFolds)
{
    const std::vector<Vec2> valley{{-4, 4}, {0, 0}, {4, 4}};
    const PolylineOffset offset =
        polyline_offset(Cutter::flat(1), valley, {.rolls_around_corners = false});
    const std::vector<Vec2> expected{{-3, 4}, {1, 0}, {-1, 0}, {3, 4}};
    EXPECT_EQ(offset.points, expected);
}

// A clockwise square has the tool outside. Its offset is a square with rounded corners.
TEST(PolylineOffset, OfAClosedOutlineIsClosed)
{
    const std::vector<Vec2> square{{0, 0}, {0, 10}, {10, 10}, {10, 0}, {0, 0}};
    const PolylineOffset offset = polyline_offset(Cutter::ball(3), square);
    EXPECT_EQ(offset.points.front(), offset.points.back());
    double area = 0;
    for (std::size_t i = 0; i + 1 < offset.points.size(); ++i) {
        EXPECT_NEAR(distance_to(square, offset.points[i]), 3, 1e-14);
        const Vec2& a = offset.points[i];
        const Vec2& b = offset.points[i + 1];
        area += (b.x() * a.y() - a.x() * b.y()) / 2;
    }
    EXPECT_NEAR(area, 100 + 4 * 30 + 9 * std::numbers::pi, 20 * 1.25e-4);
    EXPECT_EQ(offset.low_s, -3);
    EXPECT_EQ(offset.high_s, 13);
}

// Two segments that turn back on each other are a sheet, around whose edge the ball rolls.
TEST(PolylineOffset, RollsAroundTheEdgeOfASheet)
{
    const std::vector<Vec2> sheet{{0, 0}, {5, 0}, {0, 0}};
    const PolylineOffset offset = polyline_offset(Cutter::ball(1), sheet);
    double farthest = 0;
    for (const Vec2& point : offset.points) {
        EXPECT_NEAR(distance_to(sheet, point), 1, 1e-14);
        farthest = std::max(farthest, point.x());
    }
    EXPECT_NEAR(farthest, 6, 1.25e-4);
    EXPECT_EQ(offset.points.front(), offset.points.back());
}

TEST(PolylineOffset, SizeIsAnUpperEstimate)
{
    const std::vector<Vec2> zigzag{{0, 0}, {1, 5}, {2, 0}, {3, 5}, {4, 0}};
    for (const double radius : {1e-6, 1.0, 100.0})
        for (const bool rolls : {false, true}) {
            const PolylineOffsetOptions options{.rolls_around_corners = rolls};
            const Cutter ball = Cutter::ball(radius);
            EXPECT_GE(polyline_offset_size(ball, zigzag, options),
                      polyline_offset(ball, zigzag, options).points.size());
        }
    EXPECT_LT(polyline_offset_size(Cutter::ball(1e6), zigzag), 1e7);
}

TEST(PolylineOffset, RefusesWhatHasNoOffset)
{
    const std::vector<Vec2> one{{0, 0}};
    const std::vector<Vec2> repeated{{0, 0}, {0, 0}, {1, 0}};
    const std::vector<Vec2> infinite{{0, 0}, {INFINITY, 0}};
    const std::vector<Vec2> overhang{{0, 0}, {5, 5}, {4, 9}, {9, 9}};
    for (const auto& polyline : {one, repeated, infinite})
        EXPECT_THROW(polyline_offset(Cutter::ball(1), polyline), DomainError);
    EXPECT_THROW(polyline_offset(Cutter{2, 1}, overhang), GeometryError);
    EXPECT_NO_THROW(polyline_offset(Cutter::ball(1), overhang));
}

}  // namespace
}  // namespace endmill
