// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/feed_plan.h"

#include <gtest/gtest.h>

#include "endmill/process/segment_load.h"

namespace endmill {
namespace {

// A move of which nothing is said is in air, beside a pass that is still to be told.
TEST(SegmentCut, SaysNothingThatIsNotKnown)
{
    const SegmentCut cut;
    EXPECT_FALSE(cut.mu || cut.pick_feed_mm || cut.pick_feed_horizontal_mm);
    EXPECT_EQ(cut.length_mm, 0);
    EXPECT_EQ(cut.previous, PreviousPass::Beside);
    EXPECT_EQ(cut.milling, Milling::Down);
    SegmentCut first = cut;
    first.previous = PreviousPass::None;
    EXPECT_TRUE(is_air(ball_engagement(first, 5)));
}

}  // namespace
}  // namespace endmill
