// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/program.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(Program, IsEmptyAndExactUnlessToldOtherwise)
{
    const Program program;
    EXPECT_TRUE(program.path.points.empty());
    EXPECT_TRUE(program.path.conditions.empty());
    EXPECT_FALSE(program.cutter);
    EXPECT_TRUE(program.remarks.empty());
    EXPECT_EQ(program.position_error_mm, 0);
}

}  // namespace
}  // namespace endmill
