// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/engaged_region.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "random.h"

namespace endmill {
namespace {

using std::numbers::pi;

bool has(const std::vector<AzimuthRange>& ranges, double azimuth)
{
    return std::any_of(ranges.begin(), ranges.end(), [&](const AzimuthRange& range) {
        return azimuth > range.from && azimuth < range.to;
    });
}

// The definition of engagement in vectors: a point cuts if it faces the feed and is not
// within the previous pass, a cylinder along the feed and all above it.
bool cuts(const BallEngagement& e, double latitude, double azimuth)
{
    const double x = std::sin(latitude) * std::sin(azimuth);
    const double y = std::sin(latitude) * std::cos(azimuth);
    const double z = -std::cos(latitude);
    if (x * std::cos(e.lambda) + z * std::sin(e.lambda) <= 0 ||
        1 - std::cos(latitude) > e.depth_ratio)
        return false;
    if (e.previous == PreviousPass::None)
        return true;
    if (e.previous == PreviousPass::Edge)
        return y > 0;
    const double up = z * std::cos(e.lambda) - x * std::sin(e.lambda);
    const double from_axis = y + e.pick_feed_ratio * std::cos(e.mu);
    const double over_axis = up + e.pick_feed_ratio * std::sin(e.mu);
    const bool is_in_cylinder = std::hypot(from_axis, over_axis) < 1;
    return !(is_in_cylinder || (std::abs(from_axis) < 1 && over_axis > 0));
}

TEST(EngagedRanges, AreWhereThePointsCut)
{
    test::Random random{5};
    int apart = 0;
    for (int n = 0; n < 3000; ++n) {
        BallEngagement e{random.uniform(-1.4, 1.4), random.uniform(-1.3, 1.3),
                         random.uniform(0.02, 2.2), random.uniform(0.05, 1.5)};
        if (n % 4 == 0)
            e.previous = n % 8 == 0 ? PreviousPass::None : PreviousPass::Edge;
        if (n % 5 == 0)
            e.lambda = 0;
        const double latitude = random.uniform(0.01, pi / 2);
        const auto ranges = engaged_ranges(e, latitude);
        apart += ranges.size() > 1 ? 1 : 0;
        int wrong = 0;
        constexpr int looks = 720;
        for (int k = 0; k < looks; ++k) {
            const double azimuth = -pi / 2 + 2 * pi * (k + 0.37) / looks;
            wrong += has(ranges, azimuth) != cuts(e, latitude, azimuth) ? 1 : 0;
            EXPECT_EQ(is_engaged(e, latitude, azimuth), cuts(e, latitude, azimuth));
        }
        EXPECT_EQ(wrong, 0) << e.mu << ' ' << e.lambda << ' ' << e.pick_feed_ratio << ' '
                            << latitude;
        for (std::size_t k = 1; k < ranges.size(); ++k)
            EXPECT_LT(ranges[k - 1].to, ranges[k].from);
    }
    EXPECT_GT(apart, 30);
}

TEST(EngagedRanges, OnLevelGroundAreClosed)
{
    for (const double R : {0.1, 0.5, 1.2})
        for (const double latitude : {0.3, 0.8, pi / 2}) {
            const auto ranges = engaged_ranges({0, 0, R, 1}, latitude);
            ASSERT_EQ(ranges.size(), 1U);
            EXPECT_NEAR(ranges[0].from, 0, 1e-12);
            EXPECT_NEAR(std::cos(ranges[0].to),
                        std::max(-1.0, 1 - R / std::sin(latitude)), 1e-12);
        }
}

// For lambda = 0 the ends are closed (docs/methods/ball-end-milling.md, section 3.3),
// with h = cos(latitude) - b.
TEST(EngagedRanges, OfALevelFeedAreClosed)
{
    const BallEngagement e{-0.9, 0, 0.8, 1};
    const double a = 0.8 * std::cos(-0.9);
    const double b = 0.8 * std::sin(-0.9);
    for (const double latitude : {0.6, 1.0, 1.3}) {
        const double h = std::cos(latitude) - b;
        if (h >= 1)
            continue;
        const double reach = h > 0 ? std::sqrt(1 - h * h) : 1;
        const auto ranges = engaged_ranges(e, latitude);
        ASSERT_FALSE(ranges.empty());
        EXPECT_NEAR(std::sin(latitude) * std::cos(ranges[0].to), reach - a, 1e-12);
        if (ranges.size() == 2) {
            EXPECT_NEAR(std::sin(latitude) * std::cos(ranges[1].from), -reach - a, 1e-12);
        }
    }
}

TEST(EngagedRanges, NearTheTipAreARingDownhillAndNothingUphill)
{
    const auto ring = engaged_ranges({0, -0.5, 0, 1, PreviousPass::None}, 0.2);
    ASSERT_EQ(ring.size(), 1U);
    EXPECT_NEAR(ring[0].from, -pi / 2, 1e-15);
    EXPECT_NEAR(ring[0].to, 3 * pi / 2, 1e-15);
    EXPECT_TRUE(engaged_ranges({0, 0.5, 0, 1, PreviousPass::None}, 0.2).empty());
    const auto half = engaged_ranges({0, 0, 0, 1, PreviousPass::None}, 0.2);
    ASSERT_EQ(half.size(), 1U);
    EXPECT_NEAR(half[0].to - half[0].from, pi, 1e-12);
}

TEST(EngagedRanges, AreEmptyInAirAndAboveTheStock)
{
    EXPECT_TRUE(engaged_ranges({0, 0, 0.5, -1}, 0.3).empty());
    EXPECT_TRUE(engaged_ranges({0, 0, 0, 1}, 0.3).empty());
    EXPECT_TRUE(engaged_ranges({0, 0, 0.5, 0.2}, 1.2).empty());
    EXPECT_FALSE(is_engaged({0, 0, 0, 1}, 1, 1));
}

TEST(EngagedRanges, RefuseOtherLatitudes)
{
    EXPECT_THROW(engaged_ranges({0, 0, 0.5, 1}, 0), DomainError);
    EXPECT_THROW(engaged_ranges({0, 0, 0.5, 1}, 2), DomainError);
    EXPECT_THROW(engaged_ranges({0, 2, 0.5, 1}, 1), DomainError);
}

}  // namespace
}  // namespace endmill
