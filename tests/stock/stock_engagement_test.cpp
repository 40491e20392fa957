// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/stock_engagement.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/stock/removal.h"
#include "tip_path.h"

namespace endmill {
namespace {

using std::numbers::pi;

HeightStock fine_block()
{
    return block_stock({{-20, -15, -12}, {20, 15, 0}}, 0.05);
}

std::vector<Engagement> engagements(HeightStock& stock, const ToolPath& path,
                                    const Cutter& cutter,
                                    const EngagementOptions& options = {})
{
    std::vector<Engagement> all;
    for_each_engagement(
        stock, path, cutter,
        [&](std::size_t number, const Engagement& engagement) {
            EXPECT_EQ(number, all.size() + 1);
            all.push_back(engagement);
        },
        options);
    return all;
}

// A slot 2 deep in full material engages the front half of every ring up to that height.
// Near the ends of the interval the chip is thinner than a pitch.
TEST(StockEngagement, OfASlotIsTheFrontHalf)
{
    for (const Cutter& cutter : {Cutter::ball(5), Cutter::flat(5), Cutter{5, 1}}) {
        HeightStock stock = fine_block();
        const auto found = engagements(
            stock, test::tip_path({{0, 0, -2}, {1, 0, -2}, {2, 0, -2}}), cutter);
        ASSERT_EQ(found.size(), 2U);
        constexpr double two_cells = 2.01 * 2 * pi / 72;
        double highest = 0;
        for (const EngagedRing& ring : found[1].rings) {
            highest = std::max(highest, ring.above + ring.width);
            EXPECT_LT(ring.above, 2);
            ASSERT_EQ(ring.engaged.size(), 1U);
            EXPECT_NEAR(ring.engaged[0].from, -pi / 2, two_cells);
            EXPECT_NEAR(ring.engaged[0].to, pi / 2, two_cells);
            EXPECT_NEAR(cutter.profile(std::min(ring.radius, 5.0 - 1e-12)),
                        ring.latitude < 1.57 ? ring.above : cutter.corner_radius(), 1e-5);
        }
        EXPECT_GT(highest, 1.8);
    }
}

// A wall that the flat cutter overlaps by `a` engages it from the entry, sin = 1 - a / R,
// to the direction across the feed.
TEST(StockEngagement, BesideAWallIsThatOfTheRadialDepth)
{
    const double R = 5;
    for (const double a : {1.0, 2.5, 5.0, 8.0}) {
        HeightStock stock = fine_block();
        const double wall = R - a;
        remove_along(stock, test::tip_path({{-40, wall - 20, -3}, {40, wall - 20, -3}}),
                     Cutter::flat(20));
        const auto found =
            engagements(stock, test::tip_path({{0, 0, -3}, {0.2, 0, -3}}, Move::Link),
                        Cutter::flat(R), {.rings = 10, .azimuths = 360});
        ASSERT_EQ(found.size(), 1U);
        ASSERT_FALSE(found[0].rings.empty());
        for (const EngagedRing& ring : found[0].rings) {
            ASSERT_EQ(ring.engaged.size(), 1U);
            EXPECT_NEAR(ring.engaged[0].from, std::asin(1 - a / R), 0.06);
            EXPECT_NEAR(ring.engaged[0].to, pi / 2, 0.02);
        }
    }
}

// Azimuth 0 is the direction of the feed, whatever that is.
TEST(StockEngagement, TurnsWithTheFeed)
{
    for (const double degrees : {0.0, 50.0, 135.0, -90.0}) {
        const double angle = degrees * pi / 180;
        const Vec3 step{0.2 * std::cos(angle), 0.2 * std::sin(angle), 0};
        HeightStock stock = fine_block();
        const auto found = engagements(
            stock, test::tip_path({{0, 0, -2}, Vec3{0, 0, -2} + step}), Cutter::ball(5));
        ASSERT_FALSE(found[0].rings.empty());
        for (const EngagedRing& ring : found[0].rings) {
            EXPECT_NEAR(ring.engaged.front().from, -pi / 2, 0.2);
            EXPECT_NEAR(ring.engaged.back().to, pi / 2, 0.2);
        }
    }
}

TEST(StockEngagement, OfAPlungeIsAllAround)
{
    HeightStock stock = fine_block();
    const auto found =
        engagements(stock, test::tip_path({{0, 0, -1}, {0, 0, -2}, {0, 0, 3}, {0, 0, 3}}),
                    Cutter::ball(5));
    ASSERT_EQ(found.size(), 3U);
    ASSERT_FALSE(found[0].rings.empty());
    for (const EngagedRing& ring : found[0].rings) {
        ASSERT_EQ(ring.engaged.size(), 1U);
        EXPECT_NEAR(ring.engaged[0].from, -pi, 1e-12);
        EXPECT_NEAR(ring.engaged[0].to, pi, 1e-12);
    }
    EXPECT_TRUE(found[1].rings.empty());  // a move straight up
    EXPECT_TRUE(found[2].rings.empty());  // a move without length
}

TEST(StockEngagement, LeavesTheStockThatTheRemovalLeaves)
{
    const ToolPath path = test::tip_path(
        {{-8, -3, -1}, {7, 2, -4}, {30, 9, 2}, {-3, 9, -5}, {-3, 9, -9}, {2, -12, -3}});
    for (const Cutter& cutter : {Cutter::ball(4), Cutter{4, 1}}) {
        HeightStock expected = block_stock({{-20, -15, -12}, {20, 15, 0}}, 0.4);
        HeightStock stock = expected;
        remove_along(expected, path, cutter);
        engagements(stock, path, cutter);
        for (int row = 0; row < stock.grid().rows; ++row)
            for (int column = 0; column < stock.grid().columns; ++column)
                EXPECT_NEAR(stock.height(column, row), expected.height(column, row),
                            1e-12);
    }
}

TEST(StockEngagement, RefusesZeroRingsOrAzimuths)
{
    HeightStock stock = block_stock({{0, 0, 0}, {1, 1, 1}}, 0.5);
    const ToolPath path = test::tip_path({{0, 0, 0}, {1, 0, 0}});
    EXPECT_THROW(engagements(stock, path, Cutter::ball(1), {.rings = 0}), DomainError);
    EXPECT_THROW(engagements(stock, path, Cutter::ball(1), {.rings = 1, .azimuths = 0}),
                 DomainError);
}

}  // namespace
}  // namespace endmill
