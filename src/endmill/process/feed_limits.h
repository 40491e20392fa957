// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string_view>

#include "endmill/process/milling_data.h"
#include "endmill/process/tool_life.h"

namespace endmill {

/// What the engaged edges of a cutter add up to, all flutes together, without material
/// and size: the spec's A, B, A_T, B_T, or m R_m times I5, I6, I7, I8. None is negative.
struct EdgeSums {
    double chip = 0;         ///< of the chip term of tangential force, over K f_t r0
    double edge = 0;         ///< of the edge term, over K h* r0
    double chip_torque = 0;  ///< of the chip term of torque, over K f_t r0^2
    double edge_torque = 0;  ///< of the edge term, over K h* r0^2
};

/// The sums, each times `factor`: of m teeth, or a peak R_m above the mean.
EdgeSums scaled(const EdgeSums& sums, double factor);

/// Which form of a limit holds where the paper's differs from the exact one.
enum class LimitForm {
    Paper,  ///< force: the tangential one times sqrt(1 + r1^2), exact if r2 = r1; power
            /// < with 974000 kgf mm rpm/kW
    Exact,  ///< force: the root of the squares; power 2 pi n M / 60
};

/// What turns sums into forces.
struct LoadModel {
    CuttingMaterial material;
    double radius;  ///< r0 of the ball, mm
    LimitForm form = LimitForm::Exact;
};

/// What the cutter bears at one time.
struct CuttingLoads {
    double cutting_force_n = 0;  ///< across the axis
    double thrust_n = 0;         ///< along the axis
    double torque_n_m = 0;       ///< about the axis
};

/// The most that may be borne; what is not given does not bind.
struct LoadLimits {
    std::optional<double> cutting_force_n = {};  ///< N, above 0
    std::optional<double> thrust_n = {};         ///< N, above 0
    std::optional<double> torque_n_m = {};       ///< N m, above 0
};

/// Feed per tooth in mm at which each limit is reached; none where the limit does not
/// bind, 0 where the edges alone exceed it.
struct FeedBounds {
    std::optional<double> cutting_force = {};
    std::optional<double> thrust = {};
    std::optional<double> torque = {};
};

/// The loads at a feed per tooth.
/// Source: [ParkMaeng, eq. (15) to (17)] as corrected in spec of ball-end milling,
/// sections 2 and 6.
/// \pre The model is sound, the sums and the feed are not negative; not checked.
/// Relative error below 1e-15.
CuttingLoads cutting_loads(const LoadModel& model, const EdgeSums& sums,
                           double feed_per_tooth_mm);

/// The feeds at which `cutting_loads` reaches `limits`. Source: as there.
/// \pre As there, and limits are above 0; not checked.
/// Relative error below 1e-13 where the edges alone take less than 99 % of a limit.
FeedBounds feed_bounds(const LoadModel& model, const EdgeSums& sums,
                       const LoadLimits& limits);

/// Power in W that a torque takes at a speed of the spindle. Source: [ParkMaeng, eq.
/// (19)]. In the paper's form 1 kW is 974000 kgf mm rpm, 0.025 % above the exact
/// 973757.2551.
double cutting_power_w(LimitForm form, double torque_n_m, double spindle_rpm);

/// r0*, the radius in mm at which the tangential force has the torque that there is; none
/// without force. Source: [ParkMaeng, section 2] as corrected in spec of ball-end
/// milling, section 4: r0 (f_t I7 + h* I8) / (f_t I5 + h* I6).
std::optional<double> equivalent_radius(const LoadModel& model, const EdgeSums& sums,
                                        double feed_per_tooth_mm);

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

/// Stage I: the least of the bounds and the cap. It is never raised in silence: where it
/// is below the least feed per tooth, `is_infeasible` says so. A bound that is below by
/// less than a relative 1e-9 counts as equal, so that a limit computed from a feed admits
/// this feed.
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

/// \throws DomainError unless the radius is above 0, there is a flute, the time of a
///         block is not negative, and machine and speed are sound.
void require_sound(const DriveRules& rules);

/// Speed of the spindle and feed of the table.
struct TableFeed {
    double spindle_rpm;
    SpeedLimit speed_limit;
    double feed_mm_per_min;
    bool is_block_bound;  ///< slower than m f_t n, for the block to last
    double power_w;       ///< at that torque and spindle speed
};

/// Stages II to IV: the economic speed, bounded by spindle, power and feed drive (the
/// first of equals counts); then m f_t n, and no more than lets a block last. The feed
/// per tooth stays: bounded by the block rate, the chip is thinner than it says, and
/// loads are smaller.
/// Source: [ParkMaeng, eq. (18) to (21), section 4.3, stages II to IV]; spec of ball-end
/// milling, section 6.
/// \throws DomainError unless feed, length and radius are above 0, phi/pi is as said,
///         there is a flute, and the block's time is not negative.
TableFeed table_feed(const MoveDemand& move, const DriveRules& rules);

/// What a cutting move asks for, however it was found.
struct SegmentLoad {
    double length_mm;      ///< of the move, above 0
    double engaged_angle;  ///< phi of the tool's life, rad, above 0, at most pi
    FeedBounds bounds;     ///< feeds per tooth at which the limits are reached
    std::function<CuttingLoads(double feed_per_tooth_mm)>
        loads;  ///< largest in a turn; none: nothing is cut
    std::optional<double> peak_factor =
        {};  ///< R_m, largest over mean; none if there is none
};

/// What holds for all moves of a path.
struct FeedRules {
    LoadModel model;    ///< material and radius
    LoadLimits limits;  ///< of tool and spindle
    FeedRange range;    ///< feeds per tooth
    DriveRules drive;   ///< spindle and feed drives
};

/// \throws DomainError unless all is sound: material, radius, limits, range, drives.
void require_sound(const FeedRules& rules);

/// How fast a move may go, and why no faster.
struct SegmentFeed {
    double engaged_angle;  ///< rad
    ToothFeed tooth;
    std::optional<double> peak_factor;
    CuttingLoads loads;  ///< largest in a turn, at the feed per tooth of `tooth`
    TableFeed table;
};

/// Stages I to IV for one move.
/// Source: [ParkMaeng, section 4.3]; spec of ball-end milling, section 6.
/// \throws DomainError as `tooth_feed` and `table_feed`.
SegmentFeed segment_feed(const SegmentLoad& load, const FeedRules& rules);

/// What is said of the move: Infeasible before BlockRate before what governs its feed per
/// tooth.
FeedLimit reported_limit(const SegmentFeed& feed);

}  // namespace endmill
