// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/feed_svg.h"

#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

SegmentFeed row(double feed)
{
    SegmentFeed row{};
    row.table = {900, SpeedLimit::EconomicSpeed, feed, false, 0};
    return row;
}

TEST(FeedSvg, HasAPanelForEachOfTheFigures)
{
    const std::vector<SegmentCut> cuts{
        {.length_mm = 10, .mu = 0.1, .pick_feed_mm = 2, .pick_feed_horizontal_mm = 1.9},
        {.length_mm = 5, .depth_mm = 3}};
    const std::string text =
        feed_svg(cuts, std::vector{row(100), row(200)}, {"Stroke A"});
    for (const char* label :
         {"Stroke A", "across the feed", "along the feed", "between centres",
          "horizontal", "stock over the tip", "feed, mm/min", "spindle, rpm",
          "length of cut, mm", "the feed is limited by", "tool life (economic speed)"})
        EXPECT_THAT(text, testing::HasSubstr(label));
}

TEST(FeedSvg, RefusesNonFiniteNumbersAndAnotherNumberOfRows)
{
    const std::vector<SegmentCut> cuts{{.length_mm = 10}};
    EXPECT_THROW(feed_svg(cuts, {}, {}), DomainError);
    EXPECT_THROW(
        feed_svg(cuts, std::vector{row(std::numeric_limits<double>::infinity())}, {}),
        DomainError);
}

}  // namespace
}  // namespace endmill
