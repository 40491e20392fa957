// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/feed_move.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(FeedMove, StraightDownIsAPlungeAndStraightUpARetract)
{
    EXPECT_EQ(feed_move({1, 2, 3}, {1, 2, -3}), Move::Plunge);
    EXPECT_EQ(feed_move({1, 2, -3}, {1, 2, 3}), Move::Retract);
}

TEST(FeedMove, InAnyOtherDirectionIsACut)
{
    EXPECT_EQ(feed_move({1, 2, 3}, {1.1, 2, -3}), Move::Cut);
    EXPECT_EQ(feed_move({1, 2, 3}, {1, 2.1, 5}), Move::Cut);
    EXPECT_EQ(feed_move({1, 2, 3}, {4, 2, 3}), Move::Cut);
    EXPECT_EQ(feed_move({1, 2, 3}, {1, 2, 3}), Move::Cut);
}

}  // namespace
}  // namespace endmill
