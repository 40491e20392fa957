// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/fed_path.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

// [ParkMaeng, section 5]: total times in min at 80 and 40 mm/min, and with varied feed
// for aluminium and steel, rounded to 0.1.
constexpr ConstantFeedRun fast{80, 79.8};
constexpr ConstantFeedRun slow{40, 147.1};
constexpr double aluminium_min = 31.3;
constexpr double steel_min = 54.8;
constexpr double printed_length_mm = 5385.6;
constexpr double rounding_min = 0.05;

TEST(FeedTimes, GiveThePathLengthOfThePaper)
{
    const RunParts parts = parts_of_runs(fast, slow);
    EXPECT_NEAR(parts.length_mm, 5384, 1e-9);
    EXPECT_NEAR(parts.noncut_min, 12.50, 1e-12);
    // The rounding of the totals leaves an uncertainty of 8 mm and 0.15 min.
    double longest = 0;
    double slackest = 0;
    for (const double a : {-rounding_min, rounding_min})
        for (const double b : {-rounding_min, rounding_min}) {
            const RunParts other = parts_of_runs({80, 79.8 + a}, {40, 147.1 + b});
            longest = std::max(longest, other.length_mm - parts.length_mm);
            slackest = std::max(slackest, other.noncut_min - parts.noncut_min);
        }
    EXPECT_NEAR(longest, 8, 1e-9);
    EXPECT_NEAR(slackest, 0.15, 1e-12);
    EXPECT_LT(std::abs(printed_length_mm - parts.length_mm), longest);
}

TEST(FeedTimes, GiveTheNoncuttingTimeWithinRounding)
{
    const double one = fast.total_min - printed_length_mm / fast.feed_mm_per_min;
    const double other = slow.total_min - printed_length_mm / slow.feed_mm_per_min;
    EXPECT_NEAR(one, 12.48, 1e-12);
    EXPECT_NEAR(other, 12.46, 1e-12);
    EXPECT_NEAR((one + other) / 2, 12.47, 1e-12);
    EXPECT_NEAR(std::max(one, other) - rounding_min, 12.43, 1e-12);
    EXPECT_NEAR(std::min(one, other) + rounding_min, 12.51, 1e-12);
}

TEST(FeedTimes, GiveThePrintedSavings)
{
    EXPECT_NEAR(saving_percent(aluminium_min, fast.total_min), 60.777, 5e-4);
    EXPECT_NEAR(saving_percent(steel_min, slow.total_min), 62.746, 5e-4);
    // The print has 60.7 and 62.7, which the rounding of the times allows.
    EXPECT_NEAR(
        saving_percent(aluminium_min + rounding_min, fast.total_min - rounding_min),
        60.69, 5e-3);
    EXPECT_NEAR(saving_percent(steel_min + rounding_min, slow.total_min - rounding_min),
                62.70, 5e-3);
}

TEST(FeedTimes, AreTheSumOfTheirParts)
{
    const FeedTimes times = feed_times({.cut_length_mm = printed_length_mm,
                                        .cut_min = steel_min - 12.47,
                                        .noncut_min = 12.47,
                                        .constant_feed_mm_per_min = 40});
    EXPECT_NEAR(times.total_min.value(), 54.8, 1e-12);
    EXPECT_NEAR(times.constant_feed_min.value(), 147.11, 1e-12);
    EXPECT_NEAR(times.saving_percent.value(), 62.75, 5e-3);
    EXPECT_NEAR(printed_length_mm / times.cut_min, 127.2, 0.05);
    EXPECT_NEAR(saving_percent(times.cut_min, printed_length_mm / 40), 68.6, 0.05);
    EXPECT_NEAR(printed_length_mm / (aluminium_min - 12.47), 286.0, 0.05);
    EXPECT_NEAR(saving_percent(aluminium_min - 12.47, printed_length_mm / 80), 72.0,
                0.05);
}

TEST(FeedTimes, AreEmptyWhereDataAreMissing)
{
    FeedTimes times = feed_times({.cut_length_mm = 10, .cut_min = 1});
    EXPECT_FALSE(times.noncut_min || times.total_min || times.constant_feed_min ||
                 times.saving_percent);
    times =
        feed_times({.cut_length_mm = 10, .cut_min = 1, .constant_feed_mm_per_min = 5});
    EXPECT_FALSE(times.constant_feed_min || times.saving_percent);
    times = feed_times({.cut_length_mm = 10, .cut_min = 1, .noncut_min = 0});
    EXPECT_EQ(times.total_min, 1);
    EXPECT_FALSE(times.constant_feed_min || times.saving_percent);
}

TEST(FeedTimes, MayBeLongerThanAtAConstantFeed)
{
    EXPECT_NEAR(saving_percent(3, 2), -50, 1e-13);
}

TEST(FeedTimes, RefuseNumbersOutOfTheirRange)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double wrong : {0.0, -1.0, nan}) {
        EXPECT_THROW(saving_percent(wrong, 1), DomainError);
        EXPECT_THROW(saving_percent(1, wrong), DomainError);
        EXPECT_THROW(feed_times({.cut_length_mm = wrong, .cut_min = 1}), DomainError);
        EXPECT_THROW(feed_times({.cut_length_mm = 1, .cut_min = wrong}), DomainError);
        EXPECT_THROW(feed_times({.cut_length_mm = 1,
                                 .cut_min = 1,
                                 .noncut_min = 1,
                                 .constant_feed_mm_per_min = wrong}),
                     DomainError);
        EXPECT_THROW(parts_of_runs({wrong, 1}, {1, 1}), DomainError);
        EXPECT_THROW(parts_of_runs({2, wrong}, {1, 1}), DomainError);
    }
    EXPECT_THROW(feed_times({.cut_length_mm = 1, .cut_min = 1, .noncut_min = -1}),
                 DomainError);
    EXPECT_THROW(parts_of_runs({40, 100}, {40, 120}), DomainError);
}

}  // namespace
}  // namespace endmill
