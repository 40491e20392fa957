// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

#include "endmill/deviation/deviation.h"
#include "endmill/planning/economy.h"
#include "endmill/planning/path_error.h"

namespace endmill {

/// How a path is planned that is then judged.
struct PlanToJudge {
    BallCutter ball{7.5};
    double tolerance = 0.5;  ///< of chord and motion, and the scallop height, mm
    Parameter direction = Parameter::U;
    bool is_verified = false;  ///< else as the paper plans
};

/// What `plan` may leave and take: the tolerance, and tolerance and scallop height.
DeviationLimits limits_of(const PlanToJudge& plan);

/// Whether a path keeps what was asked.
enum class Keeps {
    Yes,      ///< by the bounds
    No,       ///< by a measured place
    Unknown,  ///< the bounds leave it open
};

/// The word for it in tables: "yes", "no" or "unknown".
std::string_view keeps_name(Keeps keeps);

/// A path and all that is measured of it.
struct JudgedPath {
    ToolPath path;
    std::size_t lifted_links = 0;
    std::size_t uncovered =
        0;  ///< places that the planner could not cover, see VerifiedPlan
    PathEconomy economy;
    ChordError chord;
    MotionError motion;
    Deviation left;
    Verdict verdict;
    Keeps keeps;  ///< motion error and what is left both within `limits_of`
};

/// What a ball on `path` leaves of a block on `surface`, as the command plan measures it:
/// first rays `pitch` mm apart.
Deviation deviation_of(const Surface& surface, const ToolPath& path,
                       const PlanToJudge& plan, double pitch);

/// Pitch in mm at which a surface has about `rays` of them.
double pitch_of(const Surface& surface, double rays);

/// Plans over `surface` and measures with about 100 000 first rays, as the command plan
/// does.
JudgedPath judged_path(const Surface& surface, const PlanToJudge& plan);

}  // namespace endmill
