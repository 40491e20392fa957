// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "endmill/process/cutting_load.h"
#include "endmill/process/milling_machine.h"
#include "endmill/process/tool_life.h"

namespace endmill {

/// What keeps a feed from being higher.
enum class FeedLimit {
    CuttingForce,  ///< what the tool bears across its axis
    Thrust,        ///< what it bears along its axis
    Torque,        ///< what tool or spindle bears
    Cap,           ///< largest feed per tooth for the material
    BlockRate,     ///< the shortest time that a block may last
    Infeasible     ///< no feed satisfies the limits; the least feed per tooth is used
};

/// What keeps a spindle speed from being higher.
enum class SpeedLimit {
    EconomicSpeed,  ///< the tool's life
    Spindle,        ///< its largest speed
    Power,          ///< its power
    FeedDrive       ///< the fastest feed of the machine
};

/// All of them, in the order in which the first of equals counts.
inline constexpr std::array all_feed_limits{
    FeedLimit::CuttingForce, FeedLimit::Thrust,    FeedLimit::Torque,
    FeedLimit::Cap,          FeedLimit::BlockRate, FeedLimit::Infeasible};
/// Ditto.
inline constexpr std::array all_speed_limits{SpeedLimit::EconomicSpeed,
                                             SpeedLimit::Spindle, SpeedLimit::Power,
                                             SpeedLimit::FeedDrive};

/// The word in files: "cutting_force", "thrust", "torque", "cap", "block_rate" or
/// "infeasible".
std::string_view feed_limit_name(FeedLimit limit);

/// The word in files: "economic_speed", "spindle", "power" or "feed_drive".
std::string_view speed_limit_name(SpeedLimit limit);

/// Feeds per tooth that may be used.
struct FeedRange {
    std::optional<double> most_mm = {};  ///< the cap; none: the other limits alone
    double least_mm =
        0.005;  ///< a thinner chip is rubbed, not cut; above 0, at most the cap
};

/// \throws DomainError unless the feeds are finite and as said.
void require_sound(const FeedRange& range);

/// A feed per tooth and why it is no higher.
struct ToothFeed {
    double feed_per_tooth_mm;
    FeedLimit governing;  ///< CuttingForce, Thrust, Torque or Cap
    bool is_infeasible;   ///< the governing limit is below the least feed, which is used
};

/// Stage I: the least of the bounds and the cap. It is never raised in silence: where it is
/// below the least feed per tooth, `is_infeasible` says so. A bound that is below by less than
/// a relative 1e-9 counts as equal, so that a limit computed from a feed admits this feed.
/// Source: [ParkMaeng, section 4.3, stage I]; spec of ball-end milling, section 6.
/// \throws DomainError unless the range is as said; if nothing bounds the feed.
ToothFeed tooth_feed(const FeedBounds& bounds, const FeedRange& range);

/// What stages II to IV need to know of a move.
struct MoveDemand {
    double feed_per_tooth_mm;  ///< of stage I
    double phi_over_pi;        ///< engaged angle over a half turn, above 0, at most 1
    double torque_n_m;         ///< largest, at that feed
    double length_mm;          ///< of the move, above 0
};

/// The rules of stages II to IV that are the same for all moves.
struct DriveRules {
    double radius;               ///< r0, mm
    int flutes;                  ///< m
    SpeedLine speed;             ///< of the material
    MachineLimits machine = {};  ///< its torque is not read here
    LimitForm form = LimitForm::Exact;
    double block_time_ms = 10;  ///< least time of a block; 0: no such rule
};

/// \throws DomainError unless the radius is above 0, there is a flute, the time of a block is
///         not negative, and machine and speed are sound.
void require_sound(const DriveRules& rules);

/// Speed of the spindle and feed of the table.
struct TableFeed {
    double spindle_rpm;
    SpeedLimit speed_limit;
    double feed_mm_per_min;
    bool is_block_bound;  ///< slower than m f_t n, for the block to last
    double power_w;       ///< at that torque and spindle speed
};

/// Stages II to IV: the economic speed, bounded by spindle, power and feed drive (the first
/// of equals counts); then m f_t n, and no more than lets a block last. The feed per tooth
/// stays: bounded by the block rate, the chip is thinner than it says, and loads are smaller.
/// Source: [ParkMaeng, eq. (18) to (21), section 4.3, stages II to IV]; spec of ball-end
/// milling, section 6.
/// \throws DomainError unless feed, length and radius are above 0, phi/pi is as said, there is
///         a flute, and the block's time is not negative.
TableFeed table_feed(const MoveDemand& move, const DriveRules& rules);

}  // namespace endmill
