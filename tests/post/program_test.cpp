// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/program.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(Program, IsEmptyAndExactByDefault)
{
    const Program program;
    EXPECT_TRUE(program.path.points.empty());
    EXPECT_FALSE(program.cutter);
    EXPECT_TRUE(program.remarks.empty());
    EXPECT_EQ(program.position_error_mm, 0);
}

// Ten characters take one inch, 25.4 mm.
TEST(WrittenProgram, TakesAnInchOfTapeForTenCharacters)
{
    WrittenProgram program;
    program.text = "G1 X1.234\nX2.345 Y6\n";
    EXPECT_DOUBLE_EQ(program.tape_length_m(), 2 * 0.0254);
    EXPECT_EQ(WrittenProgram{}.tape_length_m(), 0);
}

TEST(MinMax, HoldsTheEnds)
{
    MinMax range;
    EXPECT_FALSE(range.least || range.greatest);
    for (const double number : {3.0, -1.0, 7.0, 2.0})
        range.add(number);
    EXPECT_EQ(range.least, -1);
    EXPECT_EQ(range.greatest, 7);
}

}  // namespace
}  // namespace endmill
