// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "endmill/process/cutting_load.h"
#include "endmill/process/feed_limits.h"

namespace endmill {

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
FeedLimit said_limit(const SegmentFeed& feed);

}  // namespace endmill
