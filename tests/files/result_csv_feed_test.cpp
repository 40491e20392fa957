// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/result_csv.h"

#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/files/csv.h"

namespace endmill {
namespace {

constexpr const char* header =
    "pass,point,length_mm,mu_deg,lambda_deg,pick_feed_mm,pick_feed_horizontal_mm,depth_"
    "mm,"
    "engaged_angle_deg,feed_per_tooth_mm,peak_factor,limit,speed_limit,cutting_force_n,"
    "thrust_n,torque_n_m,power_w\n";

SegmentCut cut()
{
    return {.pass = 2,
            .point = 7,
            .length_mm = 1.5,
            .mu = std::numbers::pi / 6,
            .lambda = -std::numbers::pi / 4,
            .pick_feed_mm = 2,
            .pick_feed_horizontal_mm = 1.75,
            .depth_mm = 3};
}

SegmentFeed row()
{
    return {.engaged_angle = std::numbers::pi / 3,
            .tooth = {0.1, FeedLimit::Thrust, false},
            .peak_factor = 1.8,
            .loads = {1000, 400, 5.5},
            .table = {900, SpeedLimit::EconomicSpeed, 180, false, 518.25}};
}

TEST(FeedCsv, HasARowAMove)
{
    EXPECT_EQ(feed_csv(std::vector{cut()}, std::vector{row()}),
              std::string{header} +
                  "2,7,1.5,30,-45,2,1.75,3,60,0.1,1.8,thrust,"
                  "economic_speed,1000,400,5.5,518.25\n");
    EXPECT_EQ(feed_csv({}, {}), header);
}

TEST(FeedCsv, LeavesCellsEmptyWhereNothingIsKnown)
{
    SegmentCut first = cut();
    first.mu = first.pick_feed_mm = first.pick_feed_horizontal_mm = std::nullopt;
    SegmentFeed feed = row();
    feed.peak_factor = std::nullopt;
    feed.tooth.is_infeasible = true;
    feed.table.speed_limit = SpeedLimit::Power;
    EXPECT_EQ(feed_csv(std::vector{first}, std::vector{feed}),
              std::string{header} +
                  "2,7,1.5,,-45,,,3,60,0.1,,infeasible,power,1000,400,"
                  "5.5,518.25\n");
}

TEST(FeedCsv, HasTheSameColumnsForMovesBetweenTwoPasses)
{
    std::vector cuts{cut(), cut()};
    cuts[1].has_two_neighbours = true;
    const std::string text = feed_csv(cuts, std::vector{row(), row()});
    EXPECT_TRUE(text.starts_with(header));
    EXPECT_TRUE(text.ends_with(",518.25\n"));
}

TEST(FeedCsv, IsReadBackAsItWas)
{
    std::vector<SegmentCut> cuts(5000, cut());
    std::vector<SegmentFeed> rows(5000, row());
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        cuts[i].point = static_cast<int>(i);
        rows[i].tooth.feed_per_tooth_mm = 0.1 / (1 + static_cast<double>(i));
    }
    const CsvTable table = parse_csv(feed_csv(cuts, rows), "f.csv");
    ASSERT_EQ(table.rows(), cuts.size());
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        EXPECT_EQ(table.number(i, "point"), cuts[i].point);
        EXPECT_EQ(table.number(i, "feed_per_tooth_mm"), rows[i].tooth.feed_per_tooth_mm);
    }
}

TEST(FeedCsv, RefusesNumbersThatAreNotFinite)
{
    SegmentCut wrong = cut();
    wrong.mu = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(feed_csv(std::vector{wrong}, std::vector{row()}), DomainError);
    SegmentFeed endless = row();
    endless.table.power_w = std::numeric_limits<double>::infinity();
    EXPECT_THROW(feed_csv(std::vector{cut()}, std::vector{endless}), DomainError);
    EXPECT_THROW(feed_csv(std::vector{cut()}, {}), DomainError);
}

}  // namespace
}  // namespace endmill
