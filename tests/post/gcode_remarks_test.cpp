// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/gcode_remarks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "read_program.h"

namespace endmill {
namespace {

using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

// A file may repeat its codes a million times; its remarks must not.
TEST(GcodeRemarks, AreMadeOnce)
{
    std::string blocks;
    for (int i = 0; i < 100; ++i)
        blocks += "G69\nG43 H1\nG53 Z0\nG43 H2\nG0 X1 Z1\nG20\nG21\nG64\n";
    const Program program = read_gcode(program_of(blocks));
    EXPECT_THAT(program.remarks, testing::SizeIs(2));
    EXPECT_THAT(program.remarks,
                Contains("skipped codes that move nothing: G43 (200, from line 4), G64 "
                         "(100, from line 10), G69 (100, from line 3)"));
}

// One code that is not usual lists the usual ones as well.
TEST(GcodeRemarks, ListMAndGCodesInOneLine)
{
    EXPECT_THAT(
        read_gcode(program_of("G64 P0.01\nG43 H1\nM8 M101\nG4 P1\nM08\nM0\nM19 R90\nM9"))
            .remarks,
        ElementsAre("skipped codes that move nothing: G4 (1, line 6), G43 (1, line 4), "
                    "G64 (1, line 3), M0 (1, line 8), M8 (2, from line 5), M9 (1, line "
                    "10), M19 (1, line 9), M101 (1, line 5)"));
}

TEST(GcodeRemarks, AreNotMadeForUsualCodesAndASafeStart)
{
    EXPECT_THAT(
        read_gcode("G20 G64 P0.01\nT1 M6\nS900 M3\nG4 P2\nM8\nG0 G43 H1 Z1\nX0 Y0\n"
                   "G1 Z-1 F9\nX1\nG0 Z1\nM9\nM5\nM30\n")
            .remarks,
        ElementsAre());
    EXPECT_THAT(read_gcode(program_of("G64")).remarks,
                ElementsAre("skipped codes that move nothing: G64 (1, line 3)"));
}

// A rapid at the height of a cut may have run into the stock.
TEST(GcodeRemarks, StateALowStart)
{
    const auto left_out = Contains(HasSubstr("left out before it: 1 move"));
    const auto program = [](const std::string& height) {
        return "G21 G0 Z" + height + "\nX0 Y0\nG1 X1 F9\nZ-1\nX2\nM2\n";
    };
    EXPECT_THAT(read_gcode(program("-1")).remarks, left_out);
    EXPECT_THAT(read_gcode("G21 G0 Z5\nX0 Y0\nG1 Z5 X1 F9\nM2\n").remarks, left_out);
    EXPECT_THAT(read_gcode("G21 G0 Z5\nX0 Y0\nG1 Z4 X1 F9\nM2\n").remarks, ElementsAre());
}

TEST(GcodeRemarks, StateThatTheSpindleTurnsCounterclockwise)
{
    EXPECT_THAT(read_gcode(program_of("S9 M4\nG0 X1\nG1 X2 F9\nX3")).remarks,
                ElementsAre("the spindle turns counterclockwise (M4) from the move to "
                            "point 2 on; the path does not store the direction"));
    EXPECT_THAT(read_gcode(program_of("S9 M4\nG0 X1\nM3\nG1 X2 F9")).remarks,
                ElementsAre());
}

TEST(GcodeRemarks, DoNotCountRetractLevelsOfCyclesAsSkipped)
{
    EXPECT_THAT(read_gcode(program_of("G98\nG0 X1")).remarks,
                Contains("skipped codes that move nothing: G98 (1, line 3)"));
    EXPECT_THAT(read_gcode(program_of("G98 F9\nG81 X1 Z-1 R1")).remarks,
                Each(Not(HasSubstr("skipped"))));
}

}  // namespace
}  // namespace endmill
