// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// Limits of feed and spindle speed, and the four stages that apply them to one move.
///
/// EdgeSums describe the engaged edges without material and size. `cutting_loads` turns
/// them into loads at a feed per tooth, and `feed_bounds` turns limits of the loads into
/// bounds of the feed per tooth. `segment_feed` runs the stages of the paper:
/// I the feed per tooth, II and III the spindle speed, IV the table feed.
///
/// Implemented in `cutting_load.cpp` (loads and bounds) and `feed_limits.cpp` (the
/// stages).

#include <array>
#include <functional>
#include <optional>
#include <string_view>

#include "endmill/process/milling_data.h"
#include "endmill/process/tool_life.h"

namespace endmill {

/// Sums over the engaged edges of all flutes, without material and size. They are A, B,
/// A_T and B_T of docs/methods/ball-end-milling.md, section 4, or m R_m times I5, I6,
/// I7, I8. None is negative.
struct EdgeSums {
    double chip = 0;         ///< chip term of the tangential force, over K f_t r0
    double edge = 0;         ///< edge term of the tangential force, over K h* r0
    double chip_torque = 0;  ///< chip term of the torque, over K f_t r0^2
    double edge_torque = 0;  ///< edge term of the torque, over K h* r0^2
};

/// The sums multiplied by `factor`, such as the number of teeth or a peak factor.
EdgeSums scaled(const EdgeSums& sums, double factor);

/// Form of the limits of force and power, for which the paper's form differs from the
/// exact one.
enum class LimitForm {
    /// Force: tangential force times sqrt(1 + r1^2), which is exact for r2 = r1. Power:
    /// with 974000 kgf mm rpm/kW.
    Paper,
    /// Force: magnitude of tangential and radial force. Power: 2 pi n M / 60.
    Exact
};

/// Constants by which sums are multiplied to obtain forces.
struct LoadModel {
    CuttingMaterial material;           ///< force constants
    double radius;                      ///< mm, r0 of the ball
    LimitForm form = LimitForm::Exact;  ///< form of the cutting force
};

/// Loads of the cutter at one time.
struct CuttingLoads {
    double cutting_force_n = 0;  ///< N, across the axis
    double thrust_n = 0;         ///< N, along the axis
    double torque_n_m = 0;       ///< N m, about the axis
};

/// Feed per tooth in mm at which each limit is reached. std::nullopt where the limit does
/// not bind; 0 where the edge force alone exceeds it.
struct FeedBounds {
    std::optional<double> cutting_force = {};  ///< mm
    std::optional<double> thrust = {};         ///< mm
    std::optional<double> torque = {};         ///< mm
};

/// Loads at a feed per tooth.
/// Source: [ParkMaeng, eq. (15) to (17)], corrected as in
/// docs/methods/ball-end-milling.md, sections 2 and 6.
/// \pre The model is sound, and the sums and the feed are not negative; not checked.
/// Relative error below 1e-15.
CuttingLoads cutting_loads(const LoadModel& model, const EdgeSums& sums,
                           double feed_per_tooth_mm);

/// Feeds per tooth at which `cutting_loads` reaches `limits`, in closed form.
/// Source: docs/methods/ball-end-milling.md, sections 4 and 6.
/// \pre As `cutting_loads`, and the limits are above 0; not checked.
/// Relative error below 1e-13 where the edge force is less than 99 % of a limit.
FeedBounds feed_bounds(const LoadModel& model, const EdgeSums& sums,
                       const LoadLimits& limits);

/// Power in W for a torque at a spindle speed. In the paper's form 1 kW is 974000 kgf mm
/// rpm, which is 0.025 % above the exact 973757.2551.
/// Source: [ParkMaeng, eq. (19)].
double cutting_power_w(LimitForm form, double torque_n_m, double spindle_rpm);

/// Equivalent radius r0* in mm, at which the tangential force has the given torque:
/// r0 (f_t I7 + h* I8) / (f_t I5 + h* I6). std::nullopt without force.
/// Source: [ParkMaeng, section 2], corrected as in docs/methods/ball-end-milling.md,
/// section 4.
std::optional<double> equivalent_radius(const LoadModel& model, const EdgeSums& sums,
                                        double feed_per_tooth_mm);

/// Limit that governs the feed of a move.
enum class FeedLimit {
    CuttingForce,  ///< largest force of the tool across its axis
    Thrust,        ///< largest force of the tool along its axis
    Torque,        ///< largest torque of tool or spindle
    Cap,           ///< largest feed per tooth of the material
    BlockRate,     ///< shortest time of a block
    Infeasible     ///< no feed is feasible; the least feed per tooth is used
};

/// Limit that governs the spindle speed of a move.
enum class SpeedLimit {
    EconomicSpeed,  ///< economic speed of the tool life
    Spindle,        ///< largest speed of the spindle
    Power,          ///< largest power of the spindle
    FeedDrive       ///< largest feed of the machine
};

/// All feed limits. The first of several equal bounds governs.
inline constexpr std::array all_feed_limits{
    FeedLimit::CuttingForce, FeedLimit::Thrust,    FeedLimit::Torque,
    FeedLimit::Cap,          FeedLimit::BlockRate, FeedLimit::Infeasible};
/// All speed limits. The first of several equal bounds governs.
inline constexpr std::array all_speed_limits{SpeedLimit::EconomicSpeed,
                                             SpeedLimit::Spindle, SpeedLimit::Power,
                                             SpeedLimit::FeedDrive};

/// Name of a feed limit in files: "cutting_force", "thrust", "torque", "cap",
/// "block_rate" or "infeasible".
std::string_view feed_limit_name(FeedLimit limit);

/// Name of a speed limit in files: "economic_speed", "spindle", "power" or "feed_drive".
std::string_view speed_limit_name(SpeedLimit limit);

/// Range of the feed per tooth.
struct FeedRange {
    /// mm, largest feed per tooth (the cap). Without it other limits must bind.
    std::optional<double> most_mm = {};
    /// mm, least feed per tooth, above 0, at most the cap. A thinner chip rubs instead of
    /// being cut.
    double least_mm = 0.005;
};

/// Checks the range.
/// \throws DomainError if a feed is outside its range or not finite.
void require_sound(const FeedRange& range);

/// Feed per tooth of a move with its governing limit.
struct ToothFeed {
    double feed_per_tooth_mm;  ///< mm
    FeedLimit governing;       ///< CuttingForce, Thrust, Torque or Cap
    /// The governing bound is below the least feed. The least feed is used.
    bool is_infeasible;
};

/// Stage I: the smallest of the bounds and the cap. If it is below the least feed per
/// tooth, the least feed is returned and `is_infeasible` is set. A bound that is lower
/// than the least feed by less than a relative 1e-9 counts as equal to it. A limit that
/// was computed from a feed therefore admits this feed.
/// Source: [ParkMaeng, section 4.3, stage I]; docs/methods/ball-end-milling.md,
/// section 6.
/// \throws DomainError unless the range is sound, or if nothing bounds the feed.
ToothFeed tooth_feed(const FeedBounds& bounds, const FeedRange& range);

/// Data of a move for the stages II to IV.
struct MoveDemand {
    double feed_per_tooth_mm;  ///< mm, from stage I
    double phi_over_pi;        ///< engaged angle over pi, above 0, at most 1
    double torque_n_m;         ///< N m, largest torque at that feed
    double length_mm;          ///< mm, length of the move, above 0
};

/// Constants of the stages II to IV, the same for all moves.
struct DriveRules {
    double radius;               ///< mm, r0 of the ball
    int flutes;                  ///< m
    SpeedLine speed;             ///< economic speed of the material
    MachineLimits machine = {};  ///< limits of the machine; its torque is not used here
    LimitForm form = LimitForm::Exact;  ///< form of the power
    double block_time_ms = 10;  ///< ms, least time of a block; 0 switches the rule off
};

/// Checks the rules.
/// \throws DomainError unless the radius is above 0, there is a flute, the block time is
///         not negative, and machine and speed are sound.
void require_sound(const DriveRules& rules);

/// Spindle speed and table feed of a move.
struct TableFeed {
    double spindle_rpm;      ///< rpm
    SpeedLimit speed_limit;  ///< limit that governs the spindle speed
    double feed_mm_per_min;  ///< mm/min
    bool is_block_bound;     ///< the block time reduces the feed below m f_t n
    double power_w;          ///< W, at the torque of the move and this spindle speed
};

/// Stages II to IV.
/// - II and III: the spindle speed is the smallest of the economic speed and the bounds
///   of spindle, power and feed drive. The first of equal ones governs.
/// - IV: the feed is m f_t n, but no more than the block time admits. The feed per tooth
///   is not changed. If the block time limits the feed, the chip is therefore thinner and
///   the loads are smaller than stated.
/// Source: [ParkMaeng, eq. (18) to (21), section 4.3, stages II to IV];
/// docs/methods/ball-end-milling.md, section 6.
/// \throws DomainError unless feed, length and radius are above 0, phi/pi is in its
///         range, there is a flute, and the block time is not negative.
TableFeed table_feed(const MoveDemand& move, const DriveRules& rules);

/// Load of a cutting move. Its form does not depend on how it was computed.
struct SegmentLoad {
    double length_mm;      ///< mm, length of the move, above 0
    double engaged_angle;  ///< rad, phi of the tool life, above 0, at most pi
    FeedBounds bounds;     ///< feeds per tooth at which the limits are reached
    /// Largest loads in a spindle revolution as a function of the feed per tooth in mm.
    /// Empty if nothing is cut.
    std::function<CuttingLoads(double feed_per_tooth_mm)> loads;
    std::optional<double> peak_factor = {};  ///< R_m, if one factor holds for all loads
};

/// Rules for all moves of a path.
struct FeedRules {
    LoadModel model;    ///< material and radius
    LoadLimits limits;  ///< limits of tool and spindle
    FeedRange range;    ///< range of the feed per tooth
    DriveRules drive;   ///< spindle and feed drives
};

/// Checks the rules.
/// \throws DomainError unless material, radius, limits, range and drives are sound.
void require_sound(const FeedRules& rules);

/// Feed of a move with its governing limits.
struct SegmentFeed {
    double engaged_angle;               ///< rad, phi of the tool life
    ToothFeed tooth;                    ///< result of stage I
    std::optional<double> peak_factor;  ///< R_m, if one factor holds for all loads
    CuttingLoads loads;                 ///< largest loads in a spindle revolution
    TableFeed table;                    ///< result of the stages II to IV
};

/// Stages I to IV for one move.
/// Source: [ParkMaeng, section 4.3]; docs/methods/ball-end-milling.md, section 6.
/// \throws DomainError as `tooth_feed` and `table_feed`.
SegmentFeed segment_feed(const SegmentLoad& load, const FeedRules& rules);

/// The limit that is reported for a move: Infeasible, else BlockRate, else the limit that
/// governs the feed per tooth.
FeedLimit reported_limit(const SegmentFeed& feed);

}  // namespace endmill
