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

TEST(ParseGcode, RemarksThatAllMotionIsLeftOut)
{
    const Program program = read_gcode("G21 G91 G1 X1 Y1 Z1 F9\nX1\nM2\n");
    EXPECT_THAT(program.path.points, ElementsAre());
    EXPECT_THAT(program.remarks,
                ElementsAre("all motion is left out: the program does not "
                            "give every axis a position"));
}

TEST(ParseGcode, RemarksOnAssumptions)
{
    EXPECT_THAT(read_gcode("G0 X0 Y0 Z0\nM2").remarks,
                Contains("neither G20 nor G21: lengths are taken as mm"));
    EXPECT_THAT(
        read_gcode("G0 X0 Y0 Z0\nG21\nM2").remarks,
        Contains("no G20 or G21 before line 2: lengths before it are taken as mm"));
    EXPECT_THAT(read_gcode("G20 G0 X0 Y0 Z0\nM2").remarks,
                Contains("inches (G20) converted to mm"));
    EXPECT_THAT(read_gcode("G21 G0 G43 H1 Z5\nM2").remarks,
                Contains("G43 H1: the tool length is assumed to be in the control's "
                         "tool table already"));
    EXPECT_THAT(
        read_gcode("G21 G64 P0.01\nM2").remarks,
        Contains("G64: a control may round corners, which the path does not show"));
    EXPECT_THAT(read_gcode("G21 G0 X0 Y0 Z0").remarks,
                Contains("no M2, M30 or closing %: the program may be cut short"));
    EXPECT_THAT(read_gcode("%\nG21 G0 X0 Y0 Z0\n").remarks,
                Contains("no M2, M30 or closing %: the program may be cut short"));
    EXPECT_THAT(read_gcode("G21\nM2\nG0 X1\n").remarks,
                Contains("text after M2 in line 2 is ignored"));
    EXPECT_THAT(
        read_gcode(program_of("G55")).remarks,
        Contains("coordinate system first named in line 3, after motion: taken as "
                 "the system of the motion before it"));
    EXPECT_THAT(read_gcode("%\nG21\nM30\n%\n").remarks, ElementsAre());
    EXPECT_THAT(read_gcode("%\nG21\n%\nwhat is this\n").remarks, ElementsAre());
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
    EXPECT_EQ(gcode_refusal("G0 X0\n%\n"),
              "E_GCODE f.ngc:2: a first % after blocks; expected the first % before all "
              "blocks and the second at the end");
    EXPECT_EQ(gcode_refusal("%O100\n"),
              "E_GCODE f.ngc:1: \"%O100\"; expected a line with the % alone");
    EXPECT_EQ(gcode_refusal("(head)\n\n % \nG21 M2\n"), "accepted");
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

TEST(ParseGcode, ReadsTapesOfOtherSystems)
{
    EXPECT_THAT(tips(read_gcode("\xef\xbb\xbfG21 G0 X0 Y0 Z0\r\nG1 X1 F9\r\nM2\r\n")),
                ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 0)));
}

}  // namespace
}  // namespace endmill
