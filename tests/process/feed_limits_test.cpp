// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/feed_limits.h"

#include <limits>
#include <numbers>
#include <set>
#include <string_view>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "random.h"

namespace endmill {
namespace {

using test::relative_error;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr FeedRange wide{.most_mm = 0.25, .least_mm = 0.005};
constexpr SpeedLine steel_speed{0.3680141, 28.4313};
constexpr MoveDemand long_slot{
    .feed_per_tooth_mm = 0.1, .phi_over_pi = 1, .torque_n_m = 6, .length_mm = 100};

DriveRules drive(const MachineLimits& machine)
{
    return {.radius = 5, .flutes = 2, .speed = steel_speed, .machine = machine};
}

TEST(FeedLimits, HaveNamesOfTheirOwn)
{
    std::set<std::string_view> names;
    for (const FeedLimit limit : all_feed_limits)
        EXPECT_TRUE(names.insert(feed_limit_name(limit)).second);
    for (const SpeedLimit limit : all_speed_limits)
        EXPECT_TRUE(names.insert(speed_limit_name(limit)).second);
    EXPECT_FALSE(names.contains(""));
    for (std::size_t i = 0; i < all_feed_limits.size(); ++i)
        EXPECT_EQ(static_cast<std::size_t>(all_feed_limits[i]), i);
    for (std::size_t i = 0; i < all_speed_limits.size(); ++i)
        EXPECT_EQ(static_cast<std::size_t>(all_speed_limits[i]), i);
}

TEST(ToothFeed, IsTheLeastBound)
{
    const auto expect = [](const FeedBounds& bounds, double feed, FeedLimit limit) {
        const ToothFeed tooth = tooth_feed(bounds, wide);
        EXPECT_EQ(tooth.feed_per_tooth_mm, feed);
        EXPECT_EQ(tooth.governing, limit);
        EXPECT_FALSE(tooth.is_infeasible);
    };
    expect({0.1, 0.2, 0.15}, 0.1, FeedLimit::CuttingForce);
    expect({0.2, 0.1, 0.15}, 0.1, FeedLimit::Thrust);
    expect({0.2, 0.15, 0.1}, 0.1, FeedLimit::Torque);
    expect({0.3, 0.4, 0.5}, 0.25, FeedLimit::Cap);
    expect({}, 0.25, FeedLimit::Cap);
    expect({.thrust = 0.2}, 0.2, FeedLimit::Thrust);
    expect({0.1, 0.1, 0.1}, 0.1, FeedLimit::CuttingForce);
}

TEST(ToothFeed, BelowTheLeastIsReportedAsInfeasible)
{
    for (const double bound : {0.0, 1e-9, 0.004999}) {
        const ToothFeed tooth = tooth_feed({.thrust = bound}, wide);
        EXPECT_TRUE(tooth.is_infeasible);
        EXPECT_EQ(tooth.feed_per_tooth_mm, 0.005);
        EXPECT_EQ(tooth.governing, FeedLimit::Thrust);
    }
    EXPECT_FALSE(tooth_feed({.thrust = 0.005}, wide).is_infeasible);
    EXPECT_FALSE(tooth_feed({.thrust = 0.005 * (1 - 1e-12)}, wide).is_infeasible);
}

TEST(ToothFeed, NeedsABound)
{
    EXPECT_THROW(tooth_feed({}, {}), DomainError);
    EXPECT_NO_THROW(tooth_feed({.torque = 1}, {}));
    EXPECT_THROW(tooth_feed({}, {.most_mm = 0.001, .least_mm = 0.005}), DomainError);
    EXPECT_THROW(tooth_feed({}, {.most_mm = nan}), DomainError);
    EXPECT_THROW(tooth_feed({}, {.most_mm = 1, .least_mm = 0}), DomainError);
}

// docs/methods/ball-end-milling.md, section 9, A14: the other limits do not bind.
TEST(TableFeed, OfASlotAtTheEconomicSpeed)
{
    MoveDemand slot = long_slot;
    slot.feed_per_tooth_mm = 0.072097110475;
    const TableFeed table = table_feed(slot, drive({}));
    EXPECT_EQ(table.speed_limit, SpeedLimit::EconomicSpeed);
    EXPECT_LT(relative_error(table.spindle_rpm, 904.996386706), 1e-9);
    EXPECT_LT(relative_error(table.feed_mm_per_min, 130.495248944), 1e-9);
    EXPECT_FALSE(table.is_block_bound);
    EXPECT_NEAR(table.power_w, 2 * std::numbers::pi * table.spindle_rpm / 60 * 6, 1e-9);
}

TEST(TableFeed, NamesTheLimitOfTheSpindleSpeed)
{
    const auto expect = [](const MachineLimits& machine, double rpm, SpeedLimit limit) {
        const TableFeed table = table_feed(long_slot, drive(machine));
        EXPECT_LT(relative_error(table.spindle_rpm, rpm), 1e-14);
        EXPECT_EQ(table.speed_limit, limit);
        EXPECT_LT(relative_error(table.feed_mm_per_min, 0.2 * rpm), 1e-14);
    };
    expect({.max_rpm = 500}, 500, SpeedLimit::Spindle);
    expect({.max_rpm = 1000}, spindle_speed_rpm(28.4313, 5), SpeedLimit::EconomicSpeed);
    expect({.max_power_w = 6 * 10 * std::numbers::pi}, 300, SpeedLimit::Power);
    expect({.max_feed_mm_per_min = 120}, 600, SpeedLimit::FeedDrive);
    // The first of equal bounds governs.
    expect({.max_rpm = 600, .max_feed_mm_per_min = 120}, 600, SpeedLimit::Spindle);
}

TEST(TableFeed, InThePapersFormTakesItsPowerConstant)
{
    DriveRules rules = drive({.max_power_w = 100});
    rules.form = LimitForm::Paper;
    const TableFeed table = table_feed(long_slot, rules);
    EXPECT_EQ(table.speed_limit, SpeedLimit::Power);
    // P = n M / 974000 in kW and kgf mm.
    EXPECT_LT(relative_error(table.spindle_rpm * (6000 / 9.80665) / 974000, 0.1), 1e-14);
    EXPECT_NEAR(table.power_w, 100, 1e-11);
}

TEST(TableFeed, WithoutTorqueIsNotBoundByPower)
{
    MoveDemand air = long_slot;
    air.torque_n_m = 0;
    air.phi_over_pi = 5.0 / 180;
    const TableFeed table = table_feed(air, drive({.max_rpm = 3000, .max_power_w = 1}));
    EXPECT_EQ(table.speed_limit, SpeedLimit::Spindle);
    EXPECT_EQ(table.power_w, 0);
}

TEST(TableFeed, KeepsTheShortestBlockTime)
{
    test::Random random{6};
    int bound = 0;
    for (int i = 0; i < 500; ++i) {
        MoveDemand move = long_slot;
        move.length_mm = random.log_uniform(1e-4, 10);
        DriveRules rules = drive({.max_rpm = 3000});
        rules.block_time_ms = random.uniform(1, 20);
        const TableFeed table = table_feed(move, rules);
        const double lasts_ms = 60000 * move.length_mm / table.feed_mm_per_min;
        EXPECT_GE(lasts_ms, rules.block_time_ms * (1 - 1e-15));
        EXPECT_EQ(table.is_block_bound, table.feed_mm_per_min < 0.2 * table.spindle_rpm);
        bound += table.is_block_bound ? 1 : 0;
    }
    EXPECT_GT(bound, 50);
    MoveDemand move = long_slot;
    move.length_mm = 0.001;
    EXPECT_DOUBLE_EQ(table_feed(move, drive({})).feed_mm_per_min,
                     6);  // 6000 times the length
    DriveRules rules = drive({});
    rules.block_time_ms = 0;
    EXPECT_FALSE(table_feed(move, rules).is_block_bound);
}

TEST(TableFeed, RefusesNumbersOutOfTheirDomain)
{
    const auto refused = [](double MoveDemand::*member, double value) {
        MoveDemand move = long_slot;
        move.*member = value;
        EXPECT_THROW(table_feed(move, drive({})), DomainError);
    };
    for (const double value : {-1.0, nan, std::numeric_limits<double>::infinity()})
        for (double MoveDemand::*const member :
             {&MoveDemand::feed_per_tooth_mm, &MoveDemand::phi_over_pi,
              &MoveDemand::torque_n_m, &MoveDemand::length_mm})
            refused(member, value);
    refused(&MoveDemand::length_mm, 0);
    refused(&MoveDemand::phi_over_pi, 0);
    DriveRules rules = drive({});
    rules.flutes = 0;
    EXPECT_THROW(table_feed(long_slot, rules), DomainError);
    rules = drive({.max_rpm = 0});
    EXPECT_THROW(table_feed(long_slot, rules), DomainError);
    rules = drive({});
    rules.block_time_ms = -1;
    EXPECT_THROW(table_feed(long_slot, rules), DomainError);
    rules = drive({});
    rules.radius = 0;
    EXPECT_THROW(table_feed(long_slot, rules), DomainError);
}

}  // namespace
}  // namespace endmill
