// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/gcode_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "read_program.h"

namespace endmill {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::StartsWith;

// Numbers the commands, one per line, as the interpreter does.
std::string canonical(const std::string& commands)
{
    std::string text;
    int number = 0;
    for (std::size_t at = 0; at < commands.size();) {
        const std::size_t end = std::min(commands.find('\n', at), commands.size());
        text += "    " + std::to_string(++number) + " N..... " +
                commands.substr(at, end - at) + '\n';
        at = end + 1;
    }
    return text;
}

// The seven lines with which the interpreter of LinuxCNC 2.9 begins.
const std::string beginning =
    "USE_LENGTH_UNITS(CANON_UNITS_MM)\n"
    "SET_G5X_OFFSET(1, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
    "SET_G92_OFFSET(0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
    "SET_XY_ROTATION(0.0000)\nSET_FEED_REFERENCE(CANON_XYZ)\nON_RESET()\n"
    "STRAIGHT_TRAVERSE(0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n";

Program read_canonical(const std::string& commands, const GcodeReadOptions& options = {})
{
    return parse_canonical(canonical(beginning + commands), "f.txt", options);
}

std::string refusal(const std::string& commands)
{
    return refusal_of([&] { read_canonical(commands); });
}

TEST(IsCanonical, DependsOnTheFirstLine)
{
    EXPECT_TRUE(is_canonical("\n    1 N..... COMMENT(\"a\")\nanything"));
    EXPECT_TRUE(is_canonical("1 N20    FINISH()"));
    for (const std::string text : {"", "\n", "%\nG0 X1", "N10 G1 X1 (a)", "x,y\n1,2"})
        EXPECT_FALSE(is_canonical(text)) << text;
}

TEST(ParseCanonical, ReadsMovesFeedsSpindleAndTool)
{
    const Program program = read_canonical(
        "SELECT_TOOL(3)\nSTART_CHANGE()\nCHANGE_TOOL(1)\nSET_SPINDLE_SPEED(0, "
        "3000.0000)\n"
        "START_SPINDLE_CLOCKWISE(0)\nSET_FEED_RATE(800.0000)\n"
        "STRAIGHT_TRAVERSE(1.0000, 2.0000, 5.0000, 0.0000, 0.0000, 0.0000)\n"
        "STRAIGHT_FEED(1.0000, 2.0000, -1.0000, 0.0000, 0.0000, 0.0000)\n"
        "STRAIGHT_FEED(3.1234, 2.0000, -1.0000, 0.0000, 0.0000, 0.0000)\n"
        "STOP_SPINDLE_TURNING(0)\nPROGRAM_END()\nON_RESET()\n");
    EXPECT_THAT(tips(program), ElementsAre(Vec3(0, 0, 0), Vec3(1, 2, 5), Vec3(1, 2, -1),
                                           Vec3(3.1234, 2, -1)));
    EXPECT_THAT(moves(program),
                ElementsAre(Move::Rapid, Move::Rapid, Move::Plunge, Move::Cut));
    EXPECT_THAT(feeds(program), ElementsAre(std::nullopt, std::nullopt, 800, 800));
    EXPECT_EQ(program.path.points.back().conditions.spindle_rpm, 3000);
    EXPECT_EQ(program.path.points.back().conditions.tool, 3);
    EXPECT_EQ(program.path.points.front().conditions.tool, std::nullopt);
    EXPECT_EQ(program.position_error_mm, 5e-5);
    EXPECT_THAT(program.remarks, ElementsAre());
}

// The positions of the machine are 1e9 mm. Without the option they are out of range.
TEST(ParseCanonical, RisesForPositionsOfTheMachine)
{
    const std::string commands =
        "STRAIGHT_TRAVERSE(0.0, 0.0, 1000000000.0)\nSET_FEED_RATE(9.0)\n"
        "STRAIGHT_TRAVERSE(1.0, 2.0, 1000000000.0)\nSTRAIGHT_TRAVERSE(1.0, 2.0, 3.0)\n"
        "STRAIGHT_FEED(1.0, 2.0, -1.0)\nSTRAIGHT_TRAVERSE(1.0, 2.0, -1.0)\n"
        "STRAIGHT_TRAVERSE(1.0, 2.0, 1000000000.0)\n"
        "STRAIGHT_TRAVERSE(7.0, 2.0, 1000000000.0)\nSTRAIGHT_TRAVERSE(7.0, 2.0, 1.0)\n";
    const GcodeReadOptions options{.machine_position_mm = 1e8};
    const Program program = read_canonical(commands + "PROGRAM_END()\n", options);
    EXPECT_THAT(tips(program), ElementsAre(Vec3(1, 2, 3), Vec3(1, 2, -1), Vec3(1, 2, 8),
                                           Vec3(7, 2, 8), Vec3(7, 2, 1)));
    EXPECT_THAT(
        program.remarks,
        ElementsAre(StartsWith("moves to positions of the machine (G28, G30, G53): 2;")));
    EXPECT_THAT(refusal(commands), StartsWith("E_RANGE f.txt:8: coordinate 1e+09 mm"));
    EXPECT_THAT(
        refusal_of([&] {
            read_canonical(commands + "STRAIGHT_FEED(7.0, 2.0, 1000000000.0)\n", options);
        }),
        StartsWith("E_CANONICAL f.txt:17: a cut from or to a position of the machine"));
}

TEST(ParseCanonical, ReadsInches)
{
    const Program program = read_canonical(
        "USE_LENGTH_UNITS(CANON_UNITS_INCHES)\nSET_FEED_RATE(10.0000)\n"
        "STRAIGHT_FEED(1.0000, 0.0000, 0.0000)\nPROGRAM_END()");
    EXPECT_EQ(tips(program).back(), Vec3(25.4, 0, 0));
    EXPECT_EQ(feeds(program).back(), 254);
    EXPECT_EQ(program.position_error_mm, 5e-5 * 25.4);
}

struct Twin {
    const char* gcode;
    const char* commands;
};

class CanonicalArc : public testing::TestWithParam<Twin> {};

// Output of the interpreter for each arc: ends and centre in the plane's order, the
// turns, the end along the normal.
INSTANTIATE_TEST_SUITE_P(
    Planes, CanonicalArc,
    testing::Values(Twin{"G2 X5 Y5 Z-1 I5 F100",
                         "ARC_FEED(5.0000, 5.0000, 5.0000, 0.0000, -1, "
                         "-1.0000, 0.0000, 0.0000, 0.0000)"},
                    Twin{"G3 X5 Y5 J5 P2 F100",
                         "ARC_FEED(5.0000, 5.0000, 0.0000, 5.0000, 2, 0.0000, "
                         "0.0000, 0.0000, 0.0000)"},
                    Twin{"G18 G2 X5 Y1 Z5 K5 F100",
                         "SELECT_PLANE(CANON_PLANE_XZ)\nARC_FEED(5.0000, "
                         "5.0000, 5.0000, 0.0000, -1, 1.0000)"},
                    Twin{"G19 G3 X1 Y5 Z5 K5 F100",
                         "SELECT_PLANE(CANON_PLANE_YZ)\nARC_FEED(5.0000, "
                         "5.0000, 0.0000, 5.0000, 1, 1.0000)"},
                    Twin{"G2 I5 F100",
                         "ARC_FEED(0.0000, 0.0000, 5.0000, 0.0000, -1, 0.0000)"}));

TEST_P(CanonicalArc, IsThePathOfItsProgram)
{
    const Program canonical_twin =
        read_canonical(std::string{"SET_FEED_RATE(100.0000)\n"} + GetParam().commands +
                       "\nPROGRAM_END()");
    const Program twin = read_gcode(program_of(GetParam().gcode));
    EXPECT_EQ(tips(canonical_twin), tips(twin));
    EXPECT_EQ(moves(canonical_twin), moves(twin));
    EXPECT_EQ(feeds(canonical_twin), feeds(twin));
}

TEST(ParseCanonical, IgnoresCommandsThatDoNotMove)
{
    const Program program = read_canonical(
        "COMMENT(\"Move (1, 2)\")\nMESSAGE(\"x\")\nFLOOD_ON()\nMIST_OFF()\nFLOOD_OFF()\n"
        "SET_MOTION_CONTROL_MODE(CANON_CONTINUOUS, "
        "0.001000)\nSET_NAIVECAM_TOLERANCE(0.0)\n"
        "DWELL(0.5000)\nSET_FEED_MODE(0, "
        "0)\nFINISH()\nPROGRAM_STOP()\nSELECT_POCKET(1)\n"
        "STOP_CUTTER_RADIUS_COMPENSATION()\nSELECT_PLANE(CANON_PLANE_XY)\nPROGRAM_END()"
        "\n");
    EXPECT_EQ(program.path.points.size(), 1U);
}

// Output of the interpreter for M2 in its own test of a cam, except the coordinate
// system.
TEST(ParseCanonical, ReadsTheEndOfAProgram)
{
    const Program program = read_canonical(
        "SET_FEED_MODE(0, 0)\nSET_FEED_RATE(0.0000)\nSTOP_SPINDLE_TURNING(0)\n"
        "SET_SPINDLE_MODE(0 0.0000)\nPROGRAM_END()\n");
    EXPECT_THAT(program.remarks, ElementsAre());
}

TEST(ParseCanonical, TakesTheToolOfM61)
{
    EXPECT_EQ(read_canonical("CHANGE_TOOL_NUMBER(5)\nSTRAIGHT_TRAVERSE(1.0, 2.0, 3.0)")
                  .path.points.back()
                  .conditions.tool,
              5);
}

TEST(ParseCanonical, ReadsTheSpindleOfEarlierReleases)
{
    const Program program = read_canonical(
        "SET_SPINDLE_SPEED(500.0000)\nSTART_SPINDLE_COUNTERCLOCKWISE()\nSET_FEED_MODE(0)"
        "\n"
        "STRAIGHT_TRAVERSE(1.0000, 0.0000, 0.0000)\nSTOP_SPINDLE_TURNING()\n");
    EXPECT_EQ(program.path.points.back().conditions.spindle_rpm, 500);
}

TEST(ParseCanonical, RemarksOnAssumptions)
{
    EXPECT_THAT(read_canonical("").remarks,
                Contains("no PROGRAM_END: the program may be cut short"));
    EXPECT_THAT(
        read_canonical("USE_TOOL_LENGTH_OFFSET(0.0000 0.0000 25.4000, 0.0000)").remarks,
        Contains("the tool length is assumed to be in the control's tool table already"));
    EXPECT_THAT(parse_canonical("1 N..... STRAIGHT_TRAVERSE(1, 2, 3)", "f").remarks,
                Contains("no USE_LENGTH_UNITS before motion: lengths are taken as mm"));
    const Program arc_first = parse_canonical(
        canonical("SET_FEED_RATE(9.0)\nARC_FEED(1.0, 2.0, 0.0, 0.0, 1, 3.0)"), "f");
    EXPECT_THAT(tips(arc_first), ElementsAre(Vec3(1, 2, 3)));
    EXPECT_THAT(arc_first.remarks, Contains("the first motion is an arc: its start is "
                                            "unknown, and it is left out"));
}

TEST(ParseCanonical, RefusesUnsupportedMotion)
{
    for (const std::string name :
         {"STRAIGHT_PROBE", "RIGID_TAP", "NURBS_FEED", "CANON_ERROR",
          "START_SPEED_FEED_SYNCH", "WHATEVER", "START_CUTTER_RADIUS_COMPENSATION",
          "SET_ORIGIN_OFFSETS"}) {
        EXPECT_EQ(refusal(name + "(1.0000, 2.0000, 3.0000)"),
                  "E_CANONICAL f.txt:8: canonical command \"" + name +
                      "\"; expected a straight move, an arc or a command without motion");
    }
    EXPECT_EQ(refusal("SET_FEED_MODE(0, 1)"),
              "E_CANONICAL f.txt:8: feed per revolution; expected feed per minute");
    EXPECT_EQ(
        refusal("STRAIGHT_TRAVERSE(0.0000, 0.0000, 0.0000, 0.0000, 9.0000, 0.0000)"),
        "E_CANONICAL f.txt:8: a turned rotary axis; expected the machine of the program "
        "(--machine and --frame), or no turns");
    EXPECT_EQ(refusal("STRAIGHT_FEED(1.0000, 0.0000, 0.0000)"),
              "E_CANONICAL f.txt:8: a move at feed before any feed rate; expected "
              "SET_FEED_RATE above 0");
}

// The path is in the coordinates of the first move, which the beginning makes without
// offsets; the programmed points are those of the machine less the offsets.
TEST(ParseCanonical, AppliesOffsetsThatChangeAfterTheFirstMove)
{
    const std::string move = "STRAIGHT_TRAVERSE(1.0000, 2.0000, 3.0000)\n";
    EXPECT_EQ(
        tips(read_canonical("SET_G5X_OFFSET(2, 0.0000, 9.0000, 0.0000)\n" + move)).back(),
        Vec3(1, 11, 3));
    const Program both = read_canonical(
        "SET_G92_OFFSET(-1.0000, 0.0000, 0.5000)\nSET_XY_ROTATION(90.0000)\n" + move);
    EXPECT_NEAR((tips(both).back() - Vec3(-2, 0, 3.5)).norm(), 0, 1e-14);
    EXPECT_THAT(both.remarks,
                Contains("offsets change after the first move: the path is in the "
                         "coordinates of its first move"));
}

TEST(ParseCanonical, IsInTheCoordinatesOfItsFirstMove)
{
    const Program program = parse_canonical(
        canonical("USE_LENGTH_UNITS(CANON_UNITS_MM)\nSET_G92_OFFSET(5.0, 0.0, 0.0)\n"
                  "SET_XY_ROTATION(30.0)\nSTRAIGHT_TRAVERSE(1.0, 2.0, 3.0)\n"),
        "f");
    EXPECT_THAT(tips(program), ElementsAre(Vec3(1, 2, 3)));
}

// Half a circle in coordinates that are turned by 90 degrees.
TEST(ParseCanonical, TurnsArcs)
{
    const std::string turned = "SET_FEED_RATE(9.0)\nSET_XY_ROTATION(90.0)\n";
    for (const Vec3& tip :
         tips(read_canonical(turned + "ARC_FEED(10.0, 0.0, 5.0, 0.0, 1, 0.0)")))
        EXPECT_NEAR((tip - Vec3(0, 5, 0)).norm(), 5, 1e-12);
    EXPECT_EQ(
        refusal(turned + "SELECT_PLANE(CANON_PLANE_XZ)\n"
                         "ARC_FEED(10.0, 0.0, 5.0, 0.0, 1, 0.0)"),
        "E_CANONICAL f.txt:11: an arc across a turned coordinate system; expected an "
        "arc in the XY plane (G17)");
}

TEST(ParseCanonical, HasNoSpindleSpeedUnderConstantSurfaceSpeed)
{
    const Program program = read_canonical(
        "SET_SPINDLE_MODE(0 2000.0000)\nSET_SPINDLE_SPEED(0, 100.0000)\n"
        "START_SPINDLE_CLOCKWISE(0)\nSTRAIGHT_TRAVERSE(1.0, 2.0, 3.0)\n"
        "SET_SPINDLE_MODE(0 0.0000)\nSET_SPINDLE_SPEED(0, 500.0000)\n"
        "STRAIGHT_TRAVERSE(2.0, 2.0, 3.0)\n");
    EXPECT_EQ(program.path.points[1].conditions.spindle_rpm, std::nullopt);
    EXPECT_EQ(program.path.points[2].conditions.spindle_rpm, 500);
}

TEST(ParseCanonical, RefusesAProgramWithoutMotion)
{
    EXPECT_EQ(refusal_of([] { parse_canonical("1 N..... FINISH()", "f"); }),
              "E_CANONICAL f: no motion in 1 line; expected at least one "
              "STRAIGHT_TRAVERSE, STRAIGHT_FEED or ARC_FEED");
}

TEST(ParseCanonical, RefusesOtherLines)
{
    EXPECT_EQ(refusal_of([] { parse_canonical("1 N..... FINISH()\nG0 X1\n", "f"); }),
              "E_CANONICAL f:2: \"G0 X1\"; expected a line of rs274 -g, as \"12 N..... "
              "NAME(...)\"");
    EXPECT_EQ(refusal("STRAIGHT_TRAVERSE(0.0000, 0.0000)"),
              "E_CANONICAL f.txt:8: too few arguments; expected a plain decimal number");
    for (const std::string number : {"nan", "-nan", "inf", "1e5", "", "x"})
        EXPECT_EQ(
            refusal("STRAIGHT_TRAVERSE(0.0000, " + number + ", 0.0000)"),
            "E_CANONICAL f.txt:8: \"" + number + "\"; expected a plain decimal number");
    EXPECT_EQ(
        refusal("SELECT_PLANE(CANON_PLANE_UV)"),
        "E_CANONICAL f.txt:8: plane \"CANON_PLANE_UV\"; expected CANON_PLANE_XY, _XZ "
        "or _YZ");
    EXPECT_EQ(refusal("USE_LENGTH_UNITS(UNKNOWN)"),
              "E_CANONICAL f.txt:8: unit \"UNKNOWN\"; expected CANON_UNITS_MM or "
              "CANON_UNITS_INCHES");
    EXPECT_EQ(refusal("SET_FEED_RATE(-1.0000)"),
              "E_CANONICAL f.txt:8: feed rate -1; expected a feed rate of at least 0");
    EXPECT_EQ(refusal("SELECT_TOOL(-1)"),
              "E_CANONICAL f.txt:8: tool -1; expected a whole number from 0");
}

TEST(ParseCanonical, RefusesImpossibleArcs)
{
    const std::string feed = "SET_FEED_RATE(9.0000)\n";
    EXPECT_EQ(
        refusal(feed + "ARC_FEED(10.0, 0.0, 4.0, 0.0, 1, 0.0)"),
        "E_CANONICAL f.txt:9: radii of 4 mm at the arc's start and 6 mm at its end; "
        "expected a difference of at most 0.01 mm or 0.1 %");
    EXPECT_EQ(
        refusal(feed + "ARC_FEED(10.0, 0.0, 5.0, 0.0, 0, 0.0)"),
        "E_CANONICAL f.txt:9: an arc of 0 turns; expected a whole number, negative if "
        "clockwise");
    EXPECT_EQ(refusal(feed + "ARC_FEED(10.0, 0.0, 90000000.0, 0.0, 1, 0.0)"),
              "E_RANGE f.txt:9: coordinate 9e+07 mm; expected at most 1e+06 mm "
              "(--max-extent)");
    EXPECT_THAT(refusal(feed + "ARC_FEED(0.0, 0.0, 5.0, 0.0, 999999999999, 0.0)"),
                StartsWith("E_LIMIT f.txt:9: an arc of "));
}

TEST(ParseCanonical, RefusesLinesAndPathsThatAreTooLong)
{
    EXPECT_EQ(refusal_of([] { parse_canonical("\n", "f"); }),
              "E_EMPTY f: file is empty; expected a file with content");
    EXPECT_THAT(refusal("COMMENT(\"" + std::string(1U << 20U, 'x') + "\")"),
                StartsWith("E_LIMIT f.txt:8: line is longer"));
}

}  // namespace
}  // namespace endmill
