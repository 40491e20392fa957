// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/feed_limits.h"

#include <cmath>
#include <numbers>

#include "endmill/core/error.h"

namespace endmill {
namespace {

// Relative tolerance of a bound against the least feed. A limit that was computed from
// the least feed reproduces this feed up to rounding, and must not count as infeasible.
constexpr double equal_feed = 1e-9;

struct BoundedSpeed {
    double rpm;
    SpeedLimit limit;
};

// Lowers the speed to `rpm` if that is below it. Of equal bounds the first one governs.
void lower(BoundedSpeed& speed, double rpm, SpeedLimit limit)
{
    if (rpm < speed.rpm)
        speed = {rpm, limit};
}

// The spindle speed and the limit that governs it. Power is proportional to the speed, so
// the power per rpm gives the speed at which the power limit is reached.
BoundedSpeed bounded_speed(const MoveDemand& move, const DriveRules& rules)
{
    BoundedSpeed speed{
        spindle_speed_rpm(economic_speed(rules.speed, move.phi_over_pi), rules.radius),
        SpeedLimit::EconomicSpeed};
    const MachineLimits& machine = rules.machine;
    if (machine.max_rpm)
        lower(speed, *machine.max_rpm, SpeedLimit::Spindle);
    const double power_per_rpm = cutting_power_w(rules.form, move.torque_n_m, 1);
    if (machine.max_power_w && power_per_rpm > 0)
        lower(speed, *machine.max_power_w / power_per_rpm, SpeedLimit::Power);
    if (machine.max_feed_mm_per_min)
        lower(speed,
              *machine.max_feed_mm_per_min / (rules.flutes * move.feed_per_tooth_mm),
              SpeedLimit::FeedDrive);
    return speed;
}

void require_sound(const MoveDemand& move)
{
    require(std::isfinite(move.feed_per_tooth_mm) && move.feed_per_tooth_mm > 0,
            "table_feed: need 0 < feed per tooth");
    require(std::isfinite(move.length_mm) && move.length_mm > 0,
            "table_feed: need 0 < length");
    require(std::isfinite(move.torque_n_m) && move.torque_n_m >= 0,
            "table_feed: need 0 <= torque");
}

}  // namespace

std::string_view feed_limit_name(FeedLimit limit)
{
    switch (limit) {
        case FeedLimit::CuttingForce:
            return "cutting_force";
        case FeedLimit::Thrust:
            return "thrust";
        case FeedLimit::Torque:
            return "torque";
        case FeedLimit::Cap:
            return "cap";
        case FeedLimit::BlockRate:
            return "block_rate";
        case FeedLimit::Infeasible:
            return "infeasible";
    }
    return {};
}

std::string_view speed_limit_name(SpeedLimit limit)
{
    switch (limit) {
        case SpeedLimit::EconomicSpeed:
            return "economic_speed";
        case SpeedLimit::Spindle:
            return "spindle";
        case SpeedLimit::Power:
            return "power";
        case SpeedLimit::FeedDrive:
            return "feed_drive";
    }
    return {};
}

void require_sound(const FeedRange& range)
{
    require(std::isfinite(range.least_mm) && range.least_mm > 0,
            "FeedRange: need 0 < least feed per tooth");
    require(!range.most_mm ||
                (std::isfinite(*range.most_mm) && *range.most_mm >= range.least_mm),
            "FeedRange: need least feed per tooth (0.005 mm by default) <= largest");
}

void require_sound(const DriveRules& rules)
{
    require(std::isfinite(rules.radius) && rules.radius > 0,
            "DriveRules: need 0 < radius");
    require(rules.flutes >= 1, "DriveRules: need a flute");
    require(std::isfinite(rules.block_time_ms) && rules.block_time_ms >= 0,
            "DriveRules: need 0 <= time of a block");
    require_sound(rules.machine);
    require_sound(rules.speed);
}

ToothFeed tooth_feed(const FeedBounds& bounds, const FeedRange& range)
{
    require_sound(range);
    struct Bound {
        std::optional<double> feed;
        FeedLimit limit;
    };
    const std::array<Bound, 4> all{{{bounds.cutting_force, FeedLimit::CuttingForce},
                                    {bounds.thrust, FeedLimit::Thrust},
                                    {bounds.torque, FeedLimit::Torque},
                                    {range.most_mm, FeedLimit::Cap}}};
    // Of equal bounds the first one governs.
    const Bound* governing = nullptr;
    for (const Bound& bound : all)
        if (bound.feed && (governing == nullptr || *bound.feed < *governing->feed))
            governing = &bound;
    require(governing != nullptr,
            "tooth_feed: nothing bounds the feed; need a largest feed per tooth");
    const double feed = *governing->feed;
    if (feed >= range.least_mm)
        return {feed, governing->limit, false};
    return {range.least_mm, governing->limit, feed < (1 - equal_feed) * range.least_mm};
}

TableFeed table_feed(const MoveDemand& move, const DriveRules& rules)
{
    constexpr double ms_per_min = 60000;
    require_sound(move);
    require_sound(rules);
    const BoundedSpeed speed = bounded_speed(move, rules);
    const double feed = rules.flutes * move.feed_per_tooth_mm * speed.rpm;
    // The feed at which a block of this length lasts the least block time.
    const double fastest = ms_per_min * move.length_mm / rules.block_time_ms;
    const bool is_block_bound = fastest < feed;
    return {speed.rpm, speed.limit, is_block_bound ? fastest : feed, is_block_bound,
            cutting_power_w(rules.form, move.torque_n_m, speed.rpm)};
}

void require_sound(const FeedRules& rules)
{
    require_sound(rules.model.material);
    require(std::isfinite(rules.model.radius) && rules.model.radius > 0,
            "FeedRules: need 0 < radius");
    for (const auto& limit :
         {rules.limits.cutting_force_n, rules.limits.thrust_n, rules.limits.torque_n_m})
        require(!limit || (std::isfinite(*limit) && *limit > 0),
                "FeedRules: need 0 < limit");
    require_sound(rules.range);
    require_sound(rules.drive);
}

SegmentFeed segment_feed(const SegmentLoad& load, const FeedRules& rules)
{
    const ToothFeed tooth = tooth_feed(load.bounds, rules.range);
    const CuttingLoads loads =
        load.loads ? load.loads(tooth.feed_per_tooth_mm) : CuttingLoads{};
    const TableFeed table =
        table_feed({tooth.feed_per_tooth_mm, load.engaged_angle / std::numbers::pi,
                    loads.torque_n_m, load.length_mm},
                   rules.drive);
    return {load.engaged_angle, tooth, load.peak_factor, loads, table};
}

FeedLimit reported_limit(const SegmentFeed& feed)
{
    if (feed.tooth.is_infeasible)
        return FeedLimit::Infeasible;
    return feed.table.is_block_bound ? FeedLimit::BlockRate : feed.tooth.governing;
}

}  // namespace endmill
