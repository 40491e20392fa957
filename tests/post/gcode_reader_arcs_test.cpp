// SPDX-License-Identifier: GPL-3.0-or-later
// Arcs within whole programs; arc_test.cpp tests their geometry.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/post/gcode_reader.h"
#include "read_program.h"

namespace endmill {
namespace {

using std::numbers::pi;

// The tips after the start of a program at the origin.
std::vector<Vec3> arc_tips(const std::string& blocks)
{
    const auto all = tips(read_gcode(program_of("F100 " + blocks)));
    return {all.begin() + 1, all.end()};
}

double length(const std::vector<Vec3>& points)
{
    double sum = 0;
    Vec3 before = Vec3::Zero();
    for (const Vec3& point : points) {
        sum += (point - before).norm();
        before = point;
    }
    return sum;
}

// The middle point of the path, which shows on which side of its chord an arc lies.
Vec3 middle(const std::vector<Vec3>& points)
{
    return points[points.size() / 2 - 1];
}

struct Quarter {
    const char* block;
    Vec3 end;
    Vec3 centre;
    Vec3 between;  // halfway along the arc
};

const double half = std::sqrt(0.5);

class QuarterCircle : public testing::TestWithParam<Quarter> {};

// Each direction is seen from the positive end of the plane's third axis: G18 from +y,
// where z points right and x up.
INSTANTIATE_TEST_SUITE_P(
    AllPlanes, QuarterCircle,
    testing::Values(
        Quarter{"G17 G2 X5 Y5 I5", {5, 5, 0}, {5, 0, 0}, {5 - 5 * half, 5 * half, 0}},
        Quarter{"G17 G3 X5 Y5 J5", {5, 5, 0}, {0, 5, 0}, {5 * half, 5 - 5 * half, 0}},
        Quarter{"G18 G2 X5 Z5 K5", {5, 0, 5}, {0, 0, 5}, {5 * half, 0, 5 - 5 * half}},
        Quarter{"G18 G3 X5 Z5 I5", {5, 0, 5}, {5, 0, 0}, {5 - 5 * half, 0, 5 * half}},
        Quarter{"G19 G2 Y5 Z5 J5", {0, 5, 5}, {0, 5, 0}, {0, 5 - 5 * half, 5 * half}},
        Quarter{"G19 G3 Y5 Z5 K5", {0, 5, 5}, {0, 0, 5}, {0, 5 * half, 5 - 5 * half}},
        Quarter{"G17 G2 X5 Y5 R5", {5, 5, 0}, {5, 0, 0}, {5 - 5 * half, 5 * half, 0}},
        Quarter{"G18 G2 X5 Z5 R5", {5, 0, 5}, {0, 0, 5}, {5 * half, 0, 5 - 5 * half}},
        Quarter{"G17 G90.1 G2 X5 Y5 I5 J0",
                {5, 5, 0},
                {5, 0, 0},
                {5 - 5 * half, 5 * half, 0}}));

TEST_P(QuarterCircle, GoesAroundItsCentreOnTheRightSide)
{
    const Quarter& quarter = GetParam();
    const auto points = arc_tips(quarter.block);
    for (const Vec3& point : points)
        EXPECT_NEAR((point - quarter.centre).norm(), 5, 1e-13);
    EXPECT_EQ(points.back(), quarter.end);
    EXPECT_NEAR(length(points), 5 * pi / 2, 5 * pi / 2 * 1e-3);
    EXPECT_LT((middle(points) - quarter.between).norm(), 0.2);
}

TEST(ParseGcodeArcs, GoFullCirclesWithOrWithoutAxisWords)
{
    for (const std::string block : {"G2 I5", "G2 X0 Y0 I5", "G3 I5 J0", "G2\nI5"}) {
        const auto points = arc_tips(block);
        EXPECT_NEAR(length(points), 10 * pi, 0.01);
        EXPECT_EQ(points.back(), Vec3::Zero());
    }
}

TEST(ParseGcodeArcs, RepeatByTurns)
{
    EXPECT_NEAR(length(arc_tips("G2 I5 P3")), 30 * pi, 0.03);
    EXPECT_NEAR(length(arc_tips("G3 X10 R5 P2")), 15 * pi, 0.015);
}

TEST(ParseGcodeArcs, ClimbAsHelices)
{
    const auto points = arc_tips("G3 X10 Z-4 I5");
    EXPECT_EQ(points.back(), Vec3(10, 0, -4));
    EXPECT_NEAR(length(points), std::hypot(5 * pi, 4), 0.01);
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        EXPECT_LT(points[i + 1].z(), points[i].z());
    for (const Move move : moves(read_gcode(program_of("G3 X10 Z-4 I5 F9"))))
        EXPECT_TRUE(move == Move::Cut || move == Move::Rapid);
}

TEST(ParseGcodeArcs, TakeTheLargerArcForNegativeR)
{
    EXPECT_NEAR(length(arc_tips("G2 X5 Y5 R-5")), 5 * 3 * pi / 2, 0.01);
    EXPECT_NEAR(length(arc_tips("G3 X5 Y5 R-5")), 5 * 3 * pi / 2, 0.01);
    EXPECT_LT(middle(arc_tips("G3 X5 Y5 R-5")).y(), 5);
}

TEST(ParseGcodeArcs, AreInTheProgramsUnit)
{
    const auto points = arc_tips("G20 G2 X2 I1");
    EXPECT_EQ(points.back(), Vec3(50.8, 0, 0));
    EXPECT_NEAR(length(points), 25.4 * pi, 0.01);
}

TEST(ParseGcodeArcs, KeepTheToleranceAsked)
{
    const auto count = [](double tolerance) {
        return read_gcode(program_of("G2 I50 F9"), {.arc_tolerance_mm = tolerance})
                   .path.points.size() -
               1;
    };
    for (const double t : {1e-4, 1e-3, 1e-2})
        EXPECT_EQ(count(t), std::ceil(2 * pi / (2 * std::acos(1 - t / 50))));
}

TEST(ParseGcodeArcs, CloseAfterIncrementsThatDoNotSumUpExactly)
{
    // Ten increments of 0.1 end beside 1 by rounding; the circle must still be complete.
    std::string blocks = "G91 G1";
    for (int i = 0; i < 10; ++i)
        blocks += " X0.1\n";
    for (const std::string arc : {"G90 G2 X1 Y0 I5", "G90 G3 X1 Y0 I5"})
        EXPECT_NEAR(length(arc_tips(blocks + arc)), 1 + 10 * pi, 0.01);
}

TEST(ParseGcodeArcs, ShareTheTimeOfInverseTimeFeed)
{
    const Program program = read_gcode(program_of("G93 G2 X10 I5 F0.5"));
    double minutes = 0;
    for (std::size_t i = 1; i < program.path.points.size(); ++i)
        minutes += (tips(program)[i] - tips(program)[i - 1]).norm() /
                   program.path.points[i].conditions.feed_mm_per_min.value();
    EXPECT_NEAR(minutes, 2, 1e-12);
}

}  // namespace
}  // namespace endmill
