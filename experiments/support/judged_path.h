// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

#include "endmill/core/answer.h"
#include "endmill/deviation/deviation.h"
#include "endmill/planning/economy.h"
#include "endmill/planning/path_error.h"
#include "endmill/planning/planner_options.h"

namespace endmill {

/// The request for a path that is planned and then judged.
struct PlanToJudge {
    BallCutter ball{7.5};
    double tolerance = 0.5;  ///< chord and motion tolerance and scallop height, mm
    Parameter direction = Parameter::U;
    Planner planner = Planner::Paper;
};

/// Limits of `plan`: gouge up to the tolerance, remaining material up to tolerance plus scallop
/// height.
DeviationLimits limits_of(const PlanToJudge& plan);

/// "yes", "no", or "unknown" for Undecided.
std::string_view keeps_name(Answer keeps);

/// A path with its measured errors and cost.
struct JudgedPath {
    ToolPath path;
    std::size_t lifted_links;
    std::size_t uncovered;  ///< see VerifiedPlan; 0 for Planner::Paper
    PathEconomy economy;
    ChordError chord;
    MotionError motion;
    Deviation left;
    Verdict verdict;
    /// Whether motion error and deviation are within `limits_of`. Yes: the error bounds
    /// prove it. No: a measured place disproves it. Undecided: the bounds are too wide.
    Answer keeps;
};

/// Deviation of a block with the shape of `surface` after the ball has cut `path`, measured as the
/// command plan does. \param pitch distance of the first measuring rays, mm.
Deviation deviation_of(const Surface& surface, const ToolPath& path,
                       const PlanToJudge& plan, double pitch);

/// Pitch in mm that gives about `rays` measuring rays on `surface`.
double pitch_of(const Surface& surface, double rays);

/// Plans over `surface` and judges the path with about 100 000 first rays, as the command plan
/// does.
JudgedPath judged_path(const Surface& surface, const PlanToJudge& plan);

}  // namespace endmill
