// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "support/judged_path.h"

namespace endmill {

/// What one straight step of a pass does, in mm.
struct StepErrors {
    double chord;  ///< farthest that the line of the pass strays from the chord
    double gouge;  ///< deepest that the line lies inside what the ball sweeps
};

/// Of every cut of `path`, in order.
/// \pre the path is over `surface`, by plan.ball along plan.direction.
std::vector<StepErrors> step_errors(const Surface& surface, const ToolPath& path,
                                    const PlanToJudge& plan);

/// `path` with each cut replaced by `pieces` ones between contacts on the line of its
/// pass: nearly how a ball would roll along it.
ToolPath rolled_path(const Surface& surface, const ToolPath& path,
                     const PlanToJudge& plan, int pieces);

/// CL points with which `verified_pass` keeps the plan's tolerance on the passes of
/// `path`.
std::size_t verified_points(const Surface& surface, const ToolPath& path,
                            const PlanToJudge& plan);

/// What steps are held to.
struct StepRule {
    bool chord = true;    ///< the line of the pass strays no further from the chord
    bool motion = false;  ///< nor the line of the ball's centre from the chord of that
    bool paper =
        false;  ///< no longer than the paper's step for the curvature at its start
};

/// CL points of the longest steps that keep the plan's tolerance on the passes of `path`,
/// looked at in 4097 samples of each pass, between which steps end.
std::size_t greedy_points(const Surface& surface, const ToolPath& path,
                          const PlanToJudge& plan, const StepRule& rule);

/// Share in percent of the area of the first cells, between 0 and 100, that lies under more
/// than `height` mm.
double area_above_percent(const Deviation& left, double height);

}  // namespace endmill
