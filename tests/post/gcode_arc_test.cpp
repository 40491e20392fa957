// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/gcode_arc.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "read_program.h"

namespace endmill {
namespace {

const Vec3 origin = Vec3::Zero();

// The arc of `block` under `modes`, from the origin to `end`.
Arc arc_of(const std::string& modes, const std::string& block, const Vec3& end)
{
    const std::string text = modes + '\n' + block;
    TextLines lines{text, {"f", "E_GCODE"}};
    GcodeModes in_force;
    GcodeBlock words;
    while (lines.next()) {
        words = parse_block(lines.line(), lines);
        in_force.apply(words, lines);
    }
    const ArcReader reader{words, in_force, lines, GcodeReadOptions{}.max_extent_mm};
    reader.check_words();
    return reader.arc(origin, end);
}

std::string refusal(const std::string& block, const Vec3& end,
                    const std::string& modes = "G17")
{
    return refusal_of([&] { arc_of(modes, block, end); });
}

TEST(RadiusTolerance, IsAHundredthOfAMillimetreOrAThousandth)
{
    EXPECT_EQ(radius_tolerance(5), 0.01);
    EXPECT_EQ(radius_tolerance(50), 0.05);
}

TEST(ArcReader, TakesTheCentreFromTheStart)
{
    const Arc arc = arc_of("G17", "G3 X10 I5", {10, 0, 0});
    EXPECT_EQ(arc.centre, Vec3(5, 0, 0));
    EXPECT_FALSE(arc.clockwise);
    EXPECT_EQ(arc.turns, 1);
    EXPECT_EQ(arc_of("G18", "G2 X10 I5 P3", {10, 0, 0}).turns, 3);
    EXPECT_EQ(arc_of("G18", "G2 X4 Z2 K2", {2, 0, 2}).centre, Vec3(0, 0, 2));
    EXPECT_EQ(arc_of("G19", "G2 Y4 J2", {0, 4, 0}).centre, Vec3(0, 2, 0));
}

TEST(ArcReader, TakesAbsoluteCentresInTheUnit)
{
    const Arc arc = arc_of("G20 G90.1", "G2 X2 I1 J0", {50.8, 0, 0});
    EXPECT_EQ(arc.centre, Vec3(25.4, 0, 0));
}

TEST(ArcReader, FindsTheCentreOfARadius)
{
    const Vec3 below = arc_of("G17", "G2 X6 R5", {6, 0, 0}).centre;
    const Vec3 above = arc_of("G17", "G2 X6 R-5", {6, 0, 0}).centre;
    EXPECT_NEAR((below - Vec3(3, -4, 0)).norm(), 0, 1e-14);  // right triangle 3, 4, 5
    EXPECT_NEAR((above - Vec3(3, 4, 0)).norm(), 0, 1e-14);
    const Vec3 inch = arc_of("G20", "G3 X1 R1", {25.4, 0, 0}).centre;
    EXPECT_NEAR((inch - 25.4 * Vec3(0.5, std::sqrt(0.75), 0)).norm(), 0, 1e-13);
}

TEST(ArcReader, AcceptsRadiiThatRoundingExplains)
{
    EXPECT_EQ(refusal("G2 X10.009 I5", {10.009, 0, 0}), "accepted");
    EXPECT_EQ(refusal("G2 X100.09 I50", {100.09, 0, 0}, "G17"),
              "E_GCODE f:2: radii of 50 mm at "
              "the arc's start and 50.09 mm at its end; expected a difference of at most "
              "0.01 mm or 0.1 %");
    EXPECT_EQ(refusal("G2 X100.04 I50", {100.04, 0, 0}), "accepted");
    EXPECT_EQ(refusal("G2 X10.01 R5", {10.01, 0, 0}), "accepted");
}

TEST(ArcReader, RefusesImpossibleArcs)
{
    EXPECT_EQ(refusal("G2 X10", {10, 0, 0}),
              "E_GCODE f:2: an arc without centre or R; expected I, J, K or R");
    EXPECT_EQ(refusal("G2 X10 I5 R5", {10, 0, 0}),
              "E_GCODE f:2: an arc with both a centre and R; expected either of them");
    EXPECT_EQ(refusal("G2 X10 R4.98", {10, 0, 0}),
              "E_GCODE f:2: a radius R4.98 that is too small; expected at least half the "
              "distance "
              "of the arc's ends");
    EXPECT_EQ(refusal("G2 X1 R0", {1, 0, 0}),
              "E_GCODE f:2: a radius R0 that is too small; expected at least half the "
              "distance of "
              "the arc's ends");
    EXPECT_EQ(refusal("G2 X0 R5", origin),
              "E_GCODE f:2: a full circle by R; expected its centre: I, J, K");
    EXPECT_EQ(refusal("G2 X10.1 I5", {10.1, 0, 0}),
              "E_GCODE f:2: radii of 5 mm at the arc's start and 5.1 mm at its end; "
              "expected a difference of at most 0.01 mm or 0.1 %");
    EXPECT_EQ(refusal("G2 X10 I0 J0", {10, 0, 0}),
              "E_GCODE f:2: an arc of radius 0; expected a centre away from its ends");
    EXPECT_EQ(refusal("G2 X10 I10", {10, 0, 0}),
              "E_GCODE f:2: an arc of radius 0; expected a centre away from its ends");
}

TEST(ArcReader, RefusesWordsThatDoNotFitThePlane)
{
    EXPECT_EQ(
        refusal("G2 X10 I5 K1", {10, 0, 0}),
        "E_GCODE f:2: word K across the arc's plane; expected a centre in the plane "
        "of G17, G18 or G19");
    EXPECT_EQ(
        refusal("G2 X10 I5 J0", {10, 0, 0}, "G18"),
        "E_GCODE f:2: word J across the arc's plane; expected a centre in the plane "
        "of G17, G18 or G19");
    EXPECT_EQ(refusal("G2 X10 I5", {10, 0, 0}, "G90.1"),
              "E_GCODE f:2: no J under G90.1; expected both words of an absolute centre");
}

TEST(ArcReader, RefusesImpossibleTurns)
{
    for (const std::string turns : {"0", "-1", "1.5"})
        EXPECT_EQ(refusal("G2 X10 I5 P" + turns, {10, 0, 0}),
                  "E_GCODE f:2: an arc of P" + turns +
                      " turns; expected a whole number from 1");
}

TEST(ArcReader, RefusesWordsBeyondTheExtent)
{
    EXPECT_EQ(refusal("G2 X10 I5000000", {10, 0, 0}),
              "E_RANGE f:2: coordinate 5e+06 mm; expected at most 1e+06 mm "
              "(--max-extent)");
    EXPECT_EQ(refusal("G2 X10 R5000000", {10, 0, 0}),
              "E_RANGE f:2: coordinate 5e+06 mm; expected at most 1e+06 mm "
              "(--max-extent)");
}

}  // namespace
}  // namespace endmill
