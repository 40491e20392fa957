// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/verification/verification.h"
#include "support/judged_path.h"

namespace endmill {

/// The work of `endmill plan` on the default net, and of `endmill verify` on its path: a
/// ball of 15 mm, tolerances and scallop height of 0.5 mm, along u.
class DefaultNet {
public:
    explicit DefaultNet(const Surface& surface) : part_{std::vector<Surface>{surface}} {}

    /// The path with all measurements of the command.
    JudgedPath planned(Planner planner) const
    {
        return judged_path(surface(), {.planner = planner});
    }

    /// \param pitch of the stock and of the first rays, mm.
    Verdict verified(const ToolPath& path, double pitch) const
    {
        const PlanToJudge plan;
        const Cutter cutter = Cutter::ball(plan.ball.radius());
        VerificationTask task{.path = &path,
                              .cutter = cutter,
                              .judged = JudgedPart{&part_, limits_of(plan)},
                              .stock = default_block(&part_, path, cutter)};
        task.resolution = pitch;
        return verify_path(task).verdict;
    }

private:
    const Surface& surface() const
    {
        return std::get<std::vector<Surface>>(part_).front();
    }

    Part part_;
};

}  // namespace endmill
