// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/canned_cycle.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "read_program.h"

namespace endmill {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

// A program and its moves: "X Z" of a rapid, "X Z!" of a move at feed. The moves are those
// that LinuxCNC's interpreter printed, without moves of length 0.
struct Drilled {
    const char* blocks;
    const char* moves;
};

std::string moves_text(const Program& program)
{
    std::ostringstream text;
    for (const PathPoint& point : program.path.points)
        text << (text.tellp() > 0 ? ", " : "") << point.location.tip.x() << ' '
             << point.location.tip.z() << (point.conditions.feed_mm_per_min ? "!" : "");
    return text.str();
}

class DrilledProgram : public testing::TestWithParam<Drilled> {};

TEST_P(DrilledProgram, HasTheMovesOfItsCycles)
{
    const Program program = read_gcode("G21 G90 G94 G0 X0 Y0 Z10\nF100 S100 M3\n" +
                                       std::string{GetParam().blocks} + "\nM2\n");
    EXPECT_EQ(moves_text(program), std::string{"0 10, "} + GetParam().moves);
}

INSTANTIATE_TEST_SUITE_P(
    Cycles, DrilledProgram,
    testing::Values(
        Drilled{"G99 G81 X1 Z-3 R2\nX2", "1 10, 1 2, 1 -3!, 1 2, 2 2, 2 -3!, 2 2"},
        Drilled{"G98 G82 X1 Z-3 R2 P1\nX2",
                "1 10, 1 2, 1 -3!, 1 10, 2 10, 2 2, 2 -3!, 2 10"},
        Drilled{"G98 G83 Q2 X1 Z-3 R2",
                "1 10, 1 2, 1 0!, 1 2, 1 0.254, 1 -2!, 1 2, 1 -1.746, 1 -3!, 1 10"},
        Drilled{"G99 G73 X1 Z-3 R2 Q2",
                "1 10, 1 2, 1 0!, 1 0.254, 1 -2!, 1 -1.746, 1 -3!, 1 2"},
        Drilled{"G98 G84 X1 Z-3 R2", "1 10, 1 2, 1 -3!, 1 10!"},
        Drilled{"G99 G74 X1 Z-3 R2", "1 10, 1 2, 1 -3!, 1 2!"},
        Drilled{"G98 G85 X1 Z-3 R2", "1 10, 1 2, 1 -3!, 1 2!, 1 10"},
        Drilled{"G98 G86 X1 Z-3 R2 P1", "1 10, 1 2, 1 -3!, 1 10"},
        Drilled{"G98 G89 X1 Z-3 R2 P1", "1 10, 1 2, 1 -3!, 1 10!"},
        Drilled{"G99 G81 Z-3 R2", "0 2, 0 -3!, 0 2"},
        Drilled{"G99 G81 X1 Z-3 R2\nZ-4", "1 10, 1 2, 1 -3!, 1 2, 1 -4!, 1 2"}));

INSTANTIATE_TEST_SUITE_P(
    Levels, DrilledProgram,
    testing::Values(
        Drilled{
            "G0 Z1\nG99 G81 X1 Z-3 R2\nG98 X2\nX3 R0.5\nX4",
            "0 1, 0 2, 1 2, 1 -3!, 1 2, 2 2, 2 -3!, 2 2, 3 2, 3 0.5, 3 -3!, 3 1, 4 1, "
            "4 0.5, 4 -3!, 4 1"},
        Drilled{
            "G99 G81 X1 Z-3 R2\nG98 X2\nX3 R12\nX4\nR1 X5\nG80\nG81 X6 R1 Z-1",
            "1 10, 1 2, 1 -3!, 1 2, 2 10, 2 2, 2 -3!, 2 10, 2 12, 3 12, 3 -3!, 3 12, 4 "
            "12, 4 -3!, 4 12, 5 12, 5 1, 5 -3!, 5 10, 6 10, 6 1, 6 -1!, 6 10"},
        Drilled{
            "G98 G81 X1 Z-3 R12\nX2 R11\nG99 X3 R10.5\nX5 R9\nG98 X6 R8",
            "0 12, 1 12, 1 -3!, 1 12, 1 11, 2 11, 2 -3!, 2 11, 2 10.5, 3 10.5, 3 -3!, "
            "3 10.5, 5 10.5, 5 9, 5 -3!, 5 9, 6 9, 6 8, 6 -3!, 6 10"},
        Drilled{"G99 G81 X1 Z-3 R2\nX2 R5\nG98 X3 R7",
                "1 10, 1 2, 1 -3!, 1 2, 2 5, 2 -3!, 2 5, 3 10, 3 7, 3 -3!, 3 10"},
        Drilled{"G99 G81 X1 Z-3 R2\nG83 X2 Z-3 R2 Q5\nG98 G81 X3 Z-3 R2",
                "1 10, 1 2, 1 -3!, 1 2, 2 2, 2 -3!, 2 2, 3 10, 3 2, 3 -3!, 3 10"}));

INSTANTIATE_TEST_SUITE_P(
    Increments, DrilledProgram,
    testing::Values(
        Drilled{"G91 G99 G81 X1 Z-3 R-2\nX2", "1 10, 1 8, 1 5!, 1 8, 3 8, 3 5!, 3 8"},
        Drilled{"G91 G98 G81 X1 Z-3 R-2 L2",
                "1 10, 1 8, 1 5!, 1 10, 2 10, 2 8, 2 5!, 2 10"},
        Drilled{"G91 G98 G81 X1 Z-3 R-2\nX2 Z-4\nG90 X5",
                "1 10, 1 8, 1 5!, 1 10, 3 10, 3 8, 3 4!, 3 10, 5 10, 5 -2, 5 -4!, 5 10"},
        Drilled{"G0 Z1\nG91 G81 G99 X1 Y2 Z-3 R2 L3",
                "0 1, 0 3, 1 3, 1 0!, 1 3, 2 3, 2 0!, 2 3, 3 3, 3 0!, 3 3"}));

TEST(CannedCycles, RunInTheOtherPlanes)
{
    const std::string start = "G21 G0 X0 Y5 Z10 F9\n";
    EXPECT_THAT(tips(read_gcode(start + "G18 G98 G83 X1 Y-3 Z4 R2 Q3\nM2")),
                ElementsAre(Vec3(0, 5, 10), Vec3(1, 5, 4), Vec3(1, 2, 4), Vec3(1, -1, 4),
                            Vec3(1, 2, 4), Vec3(1, -1 + 0.254, 4), Vec3(1, -3, 4),
                            Vec3(1, 5, 4)));
    EXPECT_THAT(tips(read_gcode(start + "G19 G99 G81 X-3 Y4 Z1 R2\nM2")),
                ElementsAre(Vec3(0, 5, 10), Vec3(2, 5, 10), Vec3(2, 4, 1), Vec3(-3, 4, 1),
                            Vec3(2, 4, 1)));
}

TEST(CannedCycles, TakeKForTheNumberOfHoles)
{
    EXPECT_EQ(tips(read_gcode(program_of("F9\nG91 G99 G81 X1 Z-1 R1 K3"))),
              tips(read_gcode(program_of("F9\nG91 G99 G81 X1 Z-1 R1 L3"))));
}

// 25 pecks of 0.1 from 2 down to -0.5: sums of 0.1 are rounded, so a loop that adds them
// up could make one more.
TEST(CannedCycles, MakeNoPeckOfRounding)
{
    const Program program = read_gcode(program_of("F9\nG99 G73 X1 Z-0.5 R2 Q0.1"));
    std::size_t pecks = 0;
    for (const PathPoint& point : program.path.points)
        pecks += point.conditions.feed_mm_per_min ? 1 : 0;
    EXPECT_EQ(pecks, 25U);
    EXPECT_EQ(program.path.points[program.path.points.size() - 2].location.tip.z(), -0.5);
}

TEST(CannedCycles, AreInTheProgramsUnit)
{
    EXPECT_THAT(tips(read_gcode("G20 G0 X0 Y0 Z1\nG99 G81 X1 Z-1 R0.5 F9\nM2")),
                ElementsAre(Vec3(0, 0, 25.4), Vec3(25.4, 0, 25.4), Vec3(25.4, 0, 12.7),
                            Vec3(25.4, 0, -25.4), Vec3(25.4, 0, 12.7)));
}

TEST(CannedCycles, KeepTheirUnitUntilTheyEnd)
{
    const std::string cycle = "F9\nG99 G81 X1 Z-1 R1\n";
    for (const char* next : {"G20 X2", "G20\nX2", "G20 G82 X2 Z-1 R1 P1"})
        EXPECT_THAT(gcode_refusal(program_of(cycle + next)),
                    HasSubstr("G20 or G21 within a canned cycle; expected G80 before it"))
            << next;
    for (const char* next : {"G21 X2", "G20\nG21 X2", "G80\nG20\nG81 X2 Z-1 R1"})
        EXPECT_NO_THROW(read_gcode(program_of(cycle + next))) << next;
}

TEST(CannedCycles, BeginAPathAtTheirFirstHole)
{
    EXPECT_THAT(
        tips(read_gcode("G21 G0 Z10 F9\nG99 G81 X1 Y2 Z-3 R2\nM2")),
        ElementsAre(Vec3(1, 2, 10), Vec3(1, 2, 2), Vec3(1, 2, -3), Vec3(1, 2, 2)));
    EXPECT_EQ(gcode_refusal("G21 G0 X1 F9\nG81 X1 Y2 Z-3 R2\nM2"),
              "E_GCODE f.ngc:2: a canned cycle from an unknown position; expected an "
              "absolute Z before it");
}

TEST(CannedCycles, ReturnFromAReferencePositionOverTheirFirstHole)
{
    EXPECT_THAT(tips(read_gcode(program_of("G0 Z3 F9\nG28 X0 Y0\nG99 G81 X7 Y8 Z-1 R1"))),
                ElementsAre(Vec3(0, 0, 0), Vec3(0, 0, 3), Vec3(0, 0, 8), Vec3(7, 8, 8),
                            Vec3(7, 8, 3), Vec3(7, 8, 1), Vec3(7, 8, -1), Vec3(7, 8, 1)));
}

TEST(CannedCycles, AreRemarkedWhereControlsDiffer)
{
    EXPECT_THAT(read_gcode(program_of("F9\nG81 X1 Z-1 R1")).remarks,
                ElementsAre(StartsWith("neither G98 nor G99 before a canned cycle")));
    EXPECT_THAT(read_gcode(program_of("F9\nG99 G88 X1 Z-1 R1 P1")).remarks,
                ElementsAre("G88: the retract by hand is taken as a rapid"));
}

}  // namespace
}  // namespace endmill
