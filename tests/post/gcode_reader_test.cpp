// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/gcode_reader.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "read_program.h"

namespace endmill {
namespace {

using testing::Contains;
using testing::ElementsAre;

TEST(ParseGcode, ReadsMovesWithTheirKinds)
{
    const Program program = read_gcode(
        "%\n(a part)\nG21 G90 G94 G17 G40 G49 G80 G54\nT1 M6\nS3000 M3\nG0 X0 Y0 Z5\n"
        "G1 Z-1 F200\nX10 F800\nG1 Y10\nG0 Z5\nM5\nM30\n%\n");
    EXPECT_THAT(tips(program), ElementsAre(Vec3(0, 0, 5), Vec3(0, 0, -1), Vec3(10, 0, -1),
                                           Vec3(10, 10, -1), Vec3(10, 10, 5)));
    EXPECT_THAT(moves(program), ElementsAre(Move::Rapid, Move::Plunge, Move::Cut,
                                            Move::Cut, Move::Rapid));
    EXPECT_THAT(feeds(program), ElementsAre(std::nullopt, 200, 800, 800, std::nullopt));
    for (const PathPoint& point : program.path.points) {
        EXPECT_EQ(point.conditions.spindle_rpm, 3000);
        EXPECT_EQ(point.conditions.tool, 1);
    }
    EXPECT_FALSE(program.cutter);
    EXPECT_EQ(program.position_error_mm, 0);
    EXPECT_THAT(program.remarks, ElementsAre());
}

TEST(ParseGcode, LeavesMotionOutUntilEveryAxisIsKnown)
{
    const Program program =
        read_gcode("G21\nG0 Z5\nG1 F100 X1\nG91 Y3\nG90\nG2 X2 I5\nG1 Y0 Z4\nX3\nM2\n");
    EXPECT_THAT(tips(program), ElementsAre(Vec3(2, 0, 4), Vec3(3, 0, 4)));
    EXPECT_THAT(moves(program), ElementsAre(Move::Rapid, Move::Cut));
    EXPECT_THAT(program.remarks,
                ElementsAre("the path begins in line 7, where the position of every axis "
                            "is known; left out before it: 5 moves"));
}

TEST(ParseGcode, RemarksOnAssumptions)
{
    EXPECT_THAT(read_gcode("G0 X0 Y0 Z0\nM2").remarks,
                Contains("neither G20 nor G21: lengths are taken as mm"));
    EXPECT_THAT(
        read_gcode("G0 X0 Y0 Z0\nG21\nM2").remarks,
        Contains("no G20 or G21 before line 2: lengths before it are taken as mm"));
    EXPECT_THAT(read_gcode("G21 G0 X0 Y0 Z0").remarks,
                Contains("no M2, M30 or closing %: the program may be cut short"));
    EXPECT_THAT(read_gcode("%\nG21 G0 X0 Y0 Z0\n").remarks,
                Contains("no M2, M30 or closing %: the program may be cut short"));
    EXPECT_THAT(read_gcode("G21 G0 X0 Y0 Z0\nM2\nG0 X1\n").remarks,
                Contains("text after M2 in line 2 is ignored"));
    EXPECT_THAT(read_gcode(program_of("G54")).remarks, ElementsAre());
    EXPECT_THAT(read_gcode("G21 G91 G28 Z0\nG90 G55 G0 X0 Y0 Z0\nG1 X1 F9\nM2").remarks,
                ElementsAre(testing::StartsWith("moves to positions of the machine")));
    EXPECT_THAT(read_gcode("%\nG21 G0 X0 Y0 Z0\nM30\n%\n").remarks, ElementsAre());
    EXPECT_THAT(read_gcode("%\nG21 G0 X0 Y0 Z0\n%\nwhat is this\n").remarks,
                ElementsAre());
}

// The same program in four spellings: G90 and G91, mm and inches.
TEST(ParseGcode, ReadsTwinsAsOnePath)
{
    const std::string start = "G21 G90 G94 F100 G0 X10 Y0 Z0\n";
    const Program absolute = read_gcode(start +
                                        "G1 X20 Y5\nZ-5\nG3 X10 Y15 R10\nG2 X20 "
                                        "Y25 I10 Z-6\nG0 X30\nM2");
    const Program incremental = read_gcode(start +
                                           "G91\nG1 X10 Y5\nZ-5\nG3 X-10 Y10 R10\n"
                                           "G2 X10 Y10 I10 Z-1\nG0 X10\nM2");
    EXPECT_EQ(tips(absolute), tips(incremental));
    EXPECT_EQ(moves(absolute), moves(incremental));
    EXPECT_EQ(feeds(absolute), feeds(incremental));

    const Program mixed = read_gcode(start + "G1 X20\nG91 Y5\nG90 X30\nM2");
    EXPECT_THAT(tips(mixed), ElementsAre(Vec3(10, 0, 0), Vec3(20, 0, 0), Vec3(20, 5, 0),
                                         Vec3(30, 5, 0)));
}

TEST(ParseGcode, ConvertsInches)
{
    const Program program =
        read_gcode("G20 G90 G0 X1 Y0 Z0\nG1 X2 F10\nG21 X0\nF10\nX1\nG20 X1\nM2");
    EXPECT_THAT(tips(program),
                ElementsAre(Vec3(25.4, 0, 0), Vec3(50.8, 0, 0), Vec3(0, 0, 0),
                            Vec3(1, 0, 0), Vec3(25.4, 0, 0)));
    EXPECT_THAT(feeds(program), ElementsAre(std::nullopt, 254, 254, 10, 10));
}

TEST(ParseGcode, TakesFInTheUnitOfItsBlock)
{
    EXPECT_THAT(feeds(read_gcode(program_of("G20 G1 X1 F1"))),
                ElementsAre(std::nullopt, 25.4));
}

TEST(ParseGcode, TurnsInverseTimeIntoFeeds)
{
    const Program program =
        read_gcode(program_of("G93 G1 X10 F2\nX13 Y4 F10\nG0 X0\n"
                              "G94 G1 X5 F100"));
    EXPECT_THAT(feeds(program), ElementsAre(std::nullopt, 20, 50, std::nullopt, 100));
}

TEST(ParseGcode, MakesNoMotionOfModesAlone)
{
    EXPECT_EQ(read_gcode(program_of("G1 F100\nG2\nG3 F10\nG0\nG80\nG4 P1\nD1 H2\nN7"))
                  .path.points.size(),
              1U);
}

TEST(ParseGcode, IgnoresWordsWithoutEffectOnThePath)
{
    const Program program = read_gcode(program_of(
        "N10 G61\nG61.1\nG64 P0.1 Q0.2\nG49 G40 G80\nM0\nM7 M8\nM9\nM48\nM62 P1\nD5\nH5\n"
        "G4 P0.5\nM19 R90\n(a comment)\n; another\n\n   \nG1 X1 F9"));
    EXPECT_THAT(tips(program), ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 0)));
}

TEST(ParseGcode, RunsDeletedBlocksByDefault)
{
    const std::string text = program_of("/G1 X1 F9\n / G1 Y1 F9\n/#1=2");
    EXPECT_EQ(gcode_refusal(text).substr(0, 32), "E_GCODE f.ngc:5: parameter \"#1=2");
    EXPECT_EQ(read_gcode(program_of("/G1 X1 F9\n /  G1 Y1 F9")).path.points.size(), 3U);
    EXPECT_EQ(read_gcode(text, {.block_delete = true}).path.points.size(), 1U);
}

TEST(ParseGcode, EndsWithItsProgram)
{
    for (const std::string end : {"M2", "M30", "G0 X0 M02"})
        EXPECT_THAT(tips(read_gcode("G21 G0 X0 Y0 Z0\n" + end + "\nG1 X#1 (\n")),
                    Contains(Vec3(0, 0, 0)));
    EXPECT_EQ(read_gcode("%\nG21 G0 X0 Y0 Z0\n%\nG1 X#1 (\n").path.points.size(), 1U);
}

TEST(ParseGcode, TakesPercentSignsAroundAProgramOnly)
{
    EXPECT_EQ(gcode_refusal("G0 X0\n%\nG0 X1\n"),
              "E_GCODE f.ngc:2: a first % after blocks; expected the first % before all "
              "blocks and the second at the end");
    EXPECT_EQ(gcode_refusal("%G0 X0\n"),
              "E_GCODE f.ngc:1: \"%G0 X0\"; expected a line with the % alone");
    const std::string motion = "G21 G0 X0 Y0 Z0";
    EXPECT_EQ(gcode_refusal("(head)\n\n % \n" + motion + " M2\n"), "accepted");
    for (const std::string around :
         {"%\n*\n", "*\n%\n", "*\n%\n%\n", "%1001\n*\n%", "%O7 (part)\n*\n%",
          "% (part)\n*\n%", "%\nO1001 (PART)\n*\nM30\n%", ":1001\n*\nM30",
          "(head)\no7;x\n*\nM30"}) {
        const std::size_t at = around.find('*');
        EXPECT_EQ(tips(read_gcode(around.substr(0, at) + motion + around.substr(at + 1))),
                  tips(read_gcode(motion)))
            << around;
    }
}

TEST(ParseGcode, SubtractsTheHeightOfTheProgrammedPoint)
{
    const Program tip = read_gcode(program_of("G1 X10 F9\nG18 G2 X20 Z10 I10"));
    const Program centre = read_gcode(program_of("G1 X10 F9\nG18 G2 X20 Z10 I10"),
                                      {.programmed_point_height_mm = 3});
    ASSERT_EQ(tip.path.points.size(), centre.path.points.size());
    for (std::size_t i = 0; i < tip.path.points.size(); ++i)
        EXPECT_EQ(tips(tip)[i] - Vec3(0, 0, 3), tips(centre)[i]);
    EXPECT_EQ(moves(tip), moves(centre));
}

TEST(ParseGcode, ReadsRotaryWordsThatStayAtZero)
{
    EXPECT_THAT(tips(read_gcode(program_of("G0 A0 B0. C-0\nG1 X1 A0 F9\nG91 C0"))),
                ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 0)));
}

TEST(ParseGcode, NamesCodesThatItSkipsInOneRemark)
{
    const Program program =
        read_gcode(program_of("G69 G15\nG92.1\nG97 S500 M3\nG0 X1\nG97\nG99\nG50 S3000"));
    EXPECT_THAT(
        program.remarks,
        ElementsAre("skipped codes that move nothing: G15 (1, line 3), G50 (1, line "
                    "9), G69 (1, line 3), G92.1 (1, line 4), G97 (2, from line 5), "
                    "G99 (1, line 8)"));
    EXPECT_EQ(program.path.points.back().conditions.spindle_rpm, 500);
}

TEST(ParseGcode, HasNoSpindleSpeedUnderConstantSurfaceSpeed)
{
    const Program program =
        read_gcode(program_of("M3 S900\nG1 X1 F9\nG96 S200\nX2\nS250\nX3\nG97\nX4\n"
                              "G97 S800\nX5"));
    std::vector<std::optional<double>> speeds;
    for (const PathPoint& point : program.path.points)
        speeds.push_back(point.conditions.spindle_rpm);
    EXPECT_THAT(speeds, ElementsAre(std::nullopt, 900, std::nullopt, std::nullopt,
                                    std::nullopt, 800));
    EXPECT_THAT(program.remarks,
                Contains("G96: S is a cutting speed, so the path has no spindle speed "
                         "until G97"));
}

// The safe height is 5 mm above the highest point, which is the start at z 20.
TEST(ParseGcode, RisesForReferenceMovesAndComesBackOverTheNextPosition)
{
    const Program program = read_gcode(
        "G21 G90 G0 X0 Y0 Z20\nG1 Z-1 F9\nX5\nG91 G28 Z0\nG90 G0 X10 Y7\nZ2\n"
        "G1 Z-1\nG0 Z2\nG53 Z0\nG28 X0 Y0\nG0 X3 Z4 Y1\nM5\nG30\nM2");
    EXPECT_THAT(tips(program),
                ElementsAre(Vec3(0, 0, 20), Vec3(0, 0, -1), Vec3(5, 0, -1),
                            Vec3(5, 0, 25),                   // G28 Z
                            Vec3(10, 7, 25), Vec3(10, 7, 2),  // X Y, then Z
                            Vec3(10, 7, -1), Vec3(10, 7, 2), Vec3(10, 7, 25),  // G53
                            Vec3(0, 0, 25),  // the point that G28 passes
                            Vec3(3, 1, 25), Vec3(3, 1, 4), Vec3(3, 1, 25)));  // G30
    EXPECT_THAT(
        program.remarks,
        ElementsAre("moves to positions of the machine: G28 (2, from line 4), G30 "
                    "(1, line 13), G53 (1, line 9); each is taken as a rapid "
                    "straight up, to 5 mm above all points before it"));
    for (const std::size_t point : {3U, 4U, 5U, 8U, 9U, 10U, 11U, 12U})
        EXPECT_EQ(program.path.points[point].move, Move::Rapid);
}

TEST(ParseGcode, KeepsIncrementsOfAxesThatStay)
{
    const Program program =
        read_gcode(program_of("G1 X5 F9\nG91 G28 Z0\nG0 X1 Y1\nZ-3\nG90 Z4\nG1 X0"));
    EXPECT_THAT(tips(program), ElementsAre(Vec3(0, 0, 0), Vec3(5, 0, 0), Vec3(5, 0, 5),
                                           Vec3(6, 1, 5), Vec3(6, 1, 4), Vec3(0, 1, 4)));
}

TEST(ParseGcode, PassesThePointOfAReferenceMove)
{
    EXPECT_THAT(tips(read_gcode(program_of("G1 X5 F9\nG28 X7 Z3\nG0 X1 Z1"))),
                ElementsAre(Vec3(0, 0, 0), Vec3(5, 0, 0), Vec3(7, 0, 3), Vec3(7, 0, 8),
                            Vec3(1, 0, 8), Vec3(1, 0, 1)));
}

TEST(ParseGcode, BeginsAfterReferenceMovesOfTheFirstLines)
{
    const Program program =
        read_gcode("G21 G91 G28 Z0\nG28 X0 Y0\nG90 G0 X1 Y2\nZ3\nG1 X2 F9\nM2");
    EXPECT_THAT(tips(program), ElementsAre(Vec3(1, 2, 3), Vec3(2, 2, 3)));
    EXPECT_THAT(program.remarks,
                Contains(testing::StartsWith("the path begins in line 4")));
}

// X and Y go away at a height above the cuts; the tool returns at the safe height.
TEST(ParseGcode, GoesSidewaysAboveTheCutsOnly)
{
    const Program program =
        read_gcode(program_of("G1 Z-2 F9\nX5\nG0 Z1\nG28 X0 Y0\nG0 X8 Y8\nG1 X9"));
    EXPECT_THAT(tips(program), ElementsAre(Vec3(0, 0, 0), Vec3(0, 0, -2), Vec3(5, 0, -2),
                                           Vec3(5, 0, 1), Vec3(0, 0, 1), Vec3(0, 0, 6),
                                           Vec3(8, 8, 6), Vec3(8, 8, 1), Vec3(9, 8, 1)));
    // A first move at feed comes to the height at which X and Y leave.
    EXPECT_EQ(gcode_refusal("G21 G0 X0 Y0 Z5\nG1 X5 F9\nZ-2\nX9\nG0 Z5\nG28 X0 Y0\nM2"),
              "accepted");
}

// All axes leave at once. Above the cuts this is a move away; from among them it is a
// slope through the material, which only the end of the program accepts.
TEST(ParseGcode, LeavesWithAllAxesFromAboveTheCuts)
{
    EXPECT_THAT(
        tips(read_gcode(program_of("G1 X5 Z-1 F9\nG0 Z2\nG28\nG0 X8 Y8 Z2\nG1 Z-1"))),
        ElementsAre(Vec3(0, 0, 0), Vec3(5, 0, -1), Vec3(5, 0, 2), Vec3(5, 0, 7),
                    Vec3(8, 8, 7), Vec3(8, 8, 2), Vec3(8, 8, -1)));
    for (const std::string leave :
         {"G28", "G30", "G91 G28 X0 Y0 Z0", "G53 G0 X0 Y0 Z0"}) {
        const Program program = read_gcode(program_of("G1 Z-1 F9\nX5\n" + leave));
        EXPECT_EQ(tips(program).back(), Vec3(5, 0, 5)) << leave;
        EXPECT_THAT(
            program.remarks,
            Contains("a move of all axes at once to a position of the machine at z "
                     "-1 mm, not above the cuts (up to z -1 mm) (line 5)"))
            << leave;
        EXPECT_EQ(gcode_refusal(program_of("G1 Z-1 F9\nX5\n" + leave +
                                           "\nG90 G0 X9 Y9 Z5\nG1 Z-1")),
                  "E_GCODE f.ngc:5: a move of all axes at once to a position of the "
                  "machine at z -1 mm, not above the cuts (up to z -1 mm), and a cut "
                  "after it; expected a move up before it, such as G91 G28 Z0")
            << leave;
    }
}

TEST(ParseGcode, ReadsTapesOfOtherSystems)
{
    EXPECT_THAT(tips(read_gcode("\xef\xbb\xbfG21 G0 X0 Y0 Z0\r\nG1 X1 F9\r\nM2\r\n")),
                ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 0)));
}

}  // namespace
}  // namespace endmill
