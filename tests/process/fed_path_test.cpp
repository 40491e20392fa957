// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/fed_path.h"

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "path_conditions.h"

namespace endmill {
namespace {

PathPoint at(Move move, const Vec3& tip)
{
    return {0, 0, move, 0, {tip, Vec3::UnitZ()}};
}

SegmentFeed row(double feed, double speed, FeedLimit limit)
{
    SegmentFeed row{};
    row.tooth = {0.1, limit, false};
    row.table = {speed, SpeedLimit::EconomicSpeed, feed, false, 0};
    return row;
}

// A rapid, a plunge with a feed of its own, two cuts, a link and a retract.
const ToolPath path = test::with_conditions(
    {{at(Move::Rapid, {0, 0, 9}), at(Move::Plunge, {0, 0, 0}), at(Move::Cut, {4, 0, 0}),
      at(Move::Link, {4, 3, 0}), at(Move::Cut, {0, 3, 0}), at(Move::Rapid, {0, 3, 12}),
      at(Move::Retract, {0, 3, 13})}},
    {{500, 1, 7}, {50, {}, 7}, {300, {}, 7}});
const std::array<std::size_t, 2> points{2, 4};
const std::array rows{row(100, 1000, FeedLimit::Thrust), row(200, 2000, FeedLimit::Cap)};

TEST(FedPath, HasTheFeedOfEachCutAndKeepsThoseOfOtherMoves)
{
    const ToolPath fed = fed_path(path, points, rows, 200);
    ASSERT_EQ(fed.points.size(), 7u);
    EXPECT_FALSE(fed.points[0].conditions.feed_mm_per_min);
    EXPECT_EQ(fed.points[1].conditions.feed_mm_per_min, 50);
    EXPECT_EQ(fed.points[2].conditions.feed_mm_per_min, 100);
    EXPECT_EQ(fed.points[3].conditions.feed_mm_per_min, 200);
    EXPECT_EQ(fed.points[4].conditions.feed_mm_per_min, 200);
    EXPECT_FALSE(fed.points[5].conditions.feed_mm_per_min);
    EXPECT_EQ(fed.points[6].conditions.feed_mm_per_min, 200);
    EXPECT_EQ(fed.points[2].conditions.tool, 7);
}

// The spindle has the speed of the next cut.
TEST(FedPath, TurnsTheSpindleAsInTheNextCut)
{
    const ToolPath fed = fed_path(path, points, rows, 200);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(fed.points[i].conditions.spindle_rpm, 1000);
    }
    for (std::size_t i = 3; i < 7; ++i) {
        EXPECT_EQ(fed.points[i].conditions.spindle_rpm, 2000);
    }
}

TEST(FedPath, NamesTheLimitOfEachCut)
{
    const auto words = limit_words(7, points, rows);
    EXPECT_EQ(words[2], "thrust");
    EXPECT_EQ(words[4], "cap");
    for (const std::size_t i : {0, 1, 3, 5, 6}) {
        EXPECT_TRUE(words[i].empty());
    }
}

TEST(FedPath, TakesItsTimeBesidesTheCuts)
{
    const ToolPath fed = fed_path(path, points, rows, 200);
    EXPECT_DOUBLE_EQ(noncut_minutes(fed, points, 1000),
                     9 / 50.0 + 3 / 200.0 + 12 / 1000.0 + 1 / 200.0);
    EXPECT_EQ(noncut_minutes({}, {}, 1000), 0);
}

TEST(FedPath, WithoutACutKeepsItsFeeds)
{
    const ToolPath fed = fed_path(path, {}, {}, 200);
    EXPECT_EQ(fed.points[2].conditions.feed_mm_per_min, 300);
    EXPECT_EQ(fed.points[0].conditions.spindle_rpm, 1);
}

TEST(FedPath, RefusesRowsThatAreNotThePaths)
{
    const std::array<std::size_t, 2> falling{4, 2};
    const std::array<std::size_t, 2> beyond{4, 7};
    const std::array<std::size_t, 1> one{2};
    EXPECT_THROW(fed_path(path, falling, rows, 200), DomainError);
    EXPECT_THROW(fed_path(path, beyond, rows, 200), DomainError);
    EXPECT_THROW(fed_path(path, one, rows, 200), DomainError);
    EXPECT_THROW(fed_path(path, points, rows, 0), DomainError);
    EXPECT_THROW(limit_words(3, points, rows), DomainError);
    EXPECT_THROW(noncut_minutes(path, points, -1), DomainError);
    EXPECT_THROW(noncut_minutes(path, points, std::numeric_limits<double>::infinity()),
                 DomainError);
}

// The blocks of a plan follow each other; each sets its own moves.
TEST(FedPath, InBlocksHasTheFeedsOfTheWholePlan)
{
    FedPath fed{path};
    fed.plan(std::span{points}.first(1), std::span{rows}.first(1));
    EXPECT_TRUE(fed.is_planned(2));
    EXPECT_FALSE(fed.is_planned(4));
    fed.plan(std::span{points}.last(1), std::span{rows}.last(1));
    fed.complete(200);
    const ToolPath whole = fed_path(path, points, rows, 200);
    const auto words = limit_words(7, points, rows);
    for (std::size_t i = 0; i < whole.points.size(); ++i) {
        EXPECT_EQ(fed.path().points[i].conditions, whole.points[i].conditions);
        EXPECT_EQ(fed.limit_word(i), words[i]);
    }
    EXPECT_EQ(fed.noncut_minutes(1000), noncut_minutes(whole, points, 1000));
}

// Both limits of a move share one byte.
TEST(FedPath, KeepsBothLimitsOfAMove)
{
    for (const FeedLimit limit : all_feed_limits)
        for (const SpeedLimit speed : all_speed_limits) {
            SegmentFeed one = row(100, 1000, limit);
            one.tooth.is_infeasible = limit == FeedLimit::Infeasible;
            one.table.is_block_bound = limit == FeedLimit::BlockRate;
            one.table.speed_limit = speed;
            FedPath fed{path};
            fed.plan(std::span{points}.first(1), std::span{&one, 1});
            EXPECT_EQ(fed.limit(2), limit);
            EXPECT_EQ(fed.speed_limit(2), speed);
        }
}

TEST(FedPath, RefusesBlocksThatAreNotInOrder)
{
    FedPath fed{path};
    fed.plan(points, rows);
    EXPECT_THROW(fed.plan(points, rows), DomainError);
    EXPECT_THROW(fed.complete(0), DomainError);
    EXPECT_THROW(fed.noncut_minutes(-1), DomainError);
}

}  // namespace
}  // namespace endmill
