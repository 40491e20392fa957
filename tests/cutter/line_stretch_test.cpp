// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/detail/line_stretch.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(Stretch, SharedAndSpannedAreThoseOfIntervals)
{
    EXPECT_EQ(shared({0, 2}, {1, 5}).low, 1);
    EXPECT_EQ(shared({0, 2}, {1, 5}).high, 2);
    EXPECT_TRUE(shared({0, 1}, {2, 3}).is_empty());
    EXPECT_EQ(spanned({0, 1}, {2, 3}).high, 3);
    EXPECT_EQ(spanned(Stretch::none(), {2, 3}).low, 2);
    EXPECT_EQ(spanned({2, 3}, Stretch::none()).low, 2);
}

TEST(WherePositive, IsAHalfLineAllOrNothing)
{
    EXPECT_EQ(where_positive(-6, 2).low, 3);
    EXPECT_EQ(where_positive(6, -2).high, 3);
    EXPECT_FALSE(where_positive(0, 0).is_empty());
    EXPECT_TRUE(where_positive(-1, 0).is_empty());
}

TEST(WithinCircle, IsAChord)
{
    const Stretch chord = within_circle({-10, 3}, {2, 0}, 5);
    EXPECT_EQ(chord.low, 3);
    EXPECT_EQ(chord.high, 7);
    EXPECT_TRUE(within_circle({-10, 5.1}, {2, 0}, 5).is_empty());
    EXPECT_FALSE(within_circle({3, 4}, {0, 0}, 5).is_empty());
    EXPECT_TRUE(within_circle({3, 4.1}, {0, 0}, 5).is_empty());
}

}  // namespace
}  // namespace endmill
