// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/reference_moves.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(ReferenceMoves, RiseByFiveAboveAllPointsAndComeBackOverTheTarget)
{
    const TextLines lines{"text", {"f", "E_GCODE"}};
    const GcodeReadOptions options;
    ProgramBuilder builder{lines, options};
    ReferenceMoves references{builder, lines};
    references.go_rapidly({1, 2, 7});
    builder.go_to({1, 2, 3}, MoveFeed{9});
    EXPECT_FALSE(references.is_away());
    references.depart({.height_mm = 3, .moves_up = true});
    references.stay_away();
    EXPECT_TRUE(references.is_away());
    EXPECT_EQ(builder.position(), Vec3(1, 2, 12));
    references.go_rapidly({4, 5, 6});
    references.go_rapidly({4, 5, 6});
    EXPECT_EQ(references.count(), 1U);
    EXPECT_EQ(builder.point_count(), 5U);  // back over 4, 5, then down
    EXPECT_NO_THROW(references.check_cut());
    references.depart({.height_mm = 2, .moves_across = true, .moves_up = true});
    EXPECT_THROW(references.check_cut(), FormatError);
    EXPECT_THROW(references.depart({.height_mm = 2, .moves_across = true}), FormatError);
}

}  // namespace
}  // namespace endmill
