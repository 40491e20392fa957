// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/judged_path.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "endmill/core/tolerance.h"
#include "endmill/planning/iso_parametric.h"
#include "endmill/planning/verified_plan.h"
#include "endmill/surface/extent.h"
#include "endmill/verification/verification.h"

namespace endmill {
namespace {

// Number of measuring rays of the command plan.
constexpr double measured_rays = 1e5;

VerifiedPlan planned(const Surface& surface, const PlanToJudge& plan)
{
    const std::span<const Surface> surfaces{&surface, 1};
    LinkOptions link;
    link.safe_height = default_safe_height(surfaces, link.axis);
    if (plan.planner == Planner::Verified) {
        VerifiedOptions options;
        options.direction = plan.direction;
        options.tolerances = {plan.tolerance, plan.tolerance};
        options.scallop_height = plan.tolerance;
        options.link = link;
        return plan_verified(surfaces, plan.ball, options);
    }
    IsoParametricOptions options;
    options.direction = plan.direction;
    options.chord_tolerance = plan.tolerance;
    options.scallop_height = plan.tolerance;
    options.link = link;
    return {plan_iso_parametric(surface, plan.ball, options).path};
}

Answer keeps_limits(const JudgedPath& judged, const DeviationLimits& limits)
{
    // A motion may use the tolerance fully, so it gets the same slack as the verdict.
    const double most = limits.tolerance + verdict_slack;
    const double motion = judged.motion.greatest_mm();
    if (judged.verdict == Verdict::Gouged || judged.verdict == Verdict::Uncut ||
        motion > most)
        return Answer::No;
    const bool is_certain =
        judged.verdict == Verdict::Clean && motion + judged.motion.bound_mm <= most;
    return is_certain ? Answer::Yes : Answer::Undecided;
}

}  // namespace

DeviationLimits limits_of(const PlanToJudge& plan)
{
    return {plan.tolerance, 2 * plan.tolerance};
}

std::string_view keeps_name(Answer keeps)
{
    switch (keeps) {
        case Answer::Yes:
            return "yes";
        case Answer::No:
            return "no";
        case Answer::Undecided:
            break;
    }
    return "unknown";
}

Deviation deviation_of(const Surface& surface, const ToolPath& path,
                       const PlanToJudge& plan, double pitch)
{
    DeviationOptions options;
    options.limits = limits_of(plan);
    options.pitch = pitch;
    return deviation_in_block(std::vector<Surface>{surface}, path,
                              Cutter::ball(plan.ball.radius()), options);
}

double pitch_of(const Surface& surface, double rays)
{
    return std::sqrt(area(surface) / rays);
}

JudgedPath judged_path(const Surface& surface, const PlanToJudge& plan)
{
    VerifiedPlan made = planned(surface, plan);
    const std::span<const Surface> surfaces{&surface, 1};
    JudgedPath judged{std::move(made.path),
                      made.lifted_links,
                      made.uncovered.size(),
                      {},
                      {},
                      {},
                      {},
                      {},
                      {}};
    judged.economy = path_economy(judged.path);
    judged.chord = chord_error(surfaces, judged.path, plan.direction);
    judged.motion = motion_error(surfaces, judged.path, plan.ball, plan.direction);
    judged.left =
        deviation_of(surface, judged.path, plan, pitch_of(surface, measured_rays));
    judged.verdict = verdict(judged.left, limits_of(plan));
    judged.keeps = keeps_limits(judged, limits_of(plan));
    return judged;
}

}  // namespace endmill
