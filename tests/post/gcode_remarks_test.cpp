// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/gcode_remarks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "read_program.h"

namespace endmill {
namespace {

using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::Not;

// A file may repeat its codes a million times; its remarks must not.
TEST(GcodeRemarks, AreMadeOnce)
{
    std::string blocks;
    for (int i = 0; i < 100; ++i)
        blocks += "G69\nG43 H1\nG53 Z0\nG43 H2\nG0 X1 Z1\nG20\nG21\nG64\n";
    const Program program = read_gcode(program_of(blocks));
    EXPECT_THAT(program.remarks, testing::SizeIs(5));
    EXPECT_THAT(program.remarks,
                Contains("skipped codes that move nothing: G69 (100, from line 3)"));
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
