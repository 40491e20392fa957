// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/segment_load.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/process/detail/force_pattern.h"

namespace endmill {
namespace {

// The load of a move whose sums are constant over a revolution.
SegmentLoad load_of_sums(double length_mm, double life_angle, const EdgeSums& sums,
                         const FeedRules& rules)
{
    return {.length_mm = length_mm,
            .engaged_angle = life_angle,
            .bounds = feed_bounds(rules.model, sums, rules.limits),
            .loads = [sums, &rules](double feed) {
                return cutting_loads(rules.model, sums, feed);
            }};
}

// HelicalEdge refuses the same cuts; this message names the move and the options.
void require_few_windings(const SegmentCut& cut, const BallEngagement& engagement,
                          const MillingTool& tool)
{
    const double windings = std::max(1.0, engagement.depth_ratio) *
                            std::abs(std::tan(tool.helix)) / (2 * std::numbers::pi);
    if (windings > most_windings)
        throw GeometryError{
            "the move to point " + std::to_string(cut.point) + " of pass " +
            std::to_string(cut.pass) + " is cut " + to_text(cut.depth_mm) +
            " mm deep, where the flutes wind " + to_text(std::round(windings)) +
            " times about the axis; expected at most " + to_text(most_windings) +
            " times (--stock-top), or --peak constant:R"};
}

}  // namespace

BallEngagement ball_engagement(const SegmentCut& cut, double radius)
{
    const bool has_pass = cut.previous == PreviousPass::Beside;
    require(!has_pass || (cut.mu && cut.pick_feed_mm),
            "ball_engagement: need mu and the pick feed beside a previous pass");
    const BallEngagement engagement{
        .mu = cut.mu.value_or(0),
        .lambda = cut.lambda,
        .pick_feed_ratio = has_pass ? *cut.pick_feed_mm / radius : 0,
        .depth_ratio = cut.depth_mm / radius,
        .previous = cut.previous};
    require_sound(engagement);
    return engagement;
}

double tool_life_angle(const BallEngagement& engagement)
{
    const bool is_beside =
        !is_air(engagement) && engagement.previous == PreviousPass::Beside;
    return tool_life_angle(engagement, is_beside ? engaged_angle(engagement) : 0);
}

double tool_life_angle(const BallEngagement& engagement, double engaged_angle)
{
    if (is_air(engagement))
        return least_life_angle;
    switch (engagement.previous) {
        case PreviousPass::None:
            return std::numbers::pi;
        case PreviousPass::Edge:
            return std::numbers::pi / 2;
        case PreviousPass::Beside:
            break;
    }
    return std::clamp(engaged_angle, least_life_angle, std::numbers::pi);
}

EdgeSums edge_sums(const CuttingCoefficients& coefficients, int flutes, double factor)
{
    return scaled({coefficients.I5, coefficients.I6, coefficients.I7, coefficients.I8},
                  flutes * factor);
}

SegmentLoad constant_peak_load(const SegmentCut& cut, const EngagedCoefficients& engaged,
                               double factor, const FeedRules& rules)
{
    SegmentLoad load = load_of_sums(
        cut.length_mm,
        tool_life_angle(ball_engagement(cut, rules.model.radius), engaged.engaged_angle),
        edge_sums(engaged.coefficients, rules.drive.flutes, factor), rules);
    load.peak_factor = factor;
    return load;
}

SegmentLoad torque_peak_load(const SegmentCut& cut, const MillingTool& tool,
                             ChipModel chip, const FeedRules& rules)
{
    const BallEngagement engagement = ball_engagement(cut, rules.model.radius);
    if (is_air(engagement))
        return load_of_sums(cut.length_mm, least_life_angle, {}, rules);
    require_few_windings(cut, engagement, tool);
    const ForcePattern pattern{engagement, chip, tool};
    const double factor = pattern.peak_factor();
    SegmentLoad load = load_of_sums(cut.length_mm, tool_life_angle(engagement),
                                    scaled(pattern.mean(), factor), rules);
    load.peak_factor = factor;
    return load;
}

SegmentLoad direct_peak_load(const SegmentCut& cut, const MillingTool& tool,
                             ChipModel chip, const FeedRules& rules)
{
    const BallEngagement engagement = ball_engagement(cut, rules.model.radius);
    if (is_air(engagement))
        return load_of_sums(cut.length_mm, least_life_angle, {}, rules);
    require_few_windings(cut, engagement, tool);
    // A shared pointer, because a std::function must be copyable.
    const auto pattern = std::make_shared<const ForcePattern>(engagement, chip, tool);
    return {.length_mm = cut.length_mm,
            .engaged_angle = tool_life_angle(engagement),
            .bounds = pattern->direct_bounds(rules.model, rules.limits),
            .loads = [pattern, &rules](double feed) {
                return pattern->largest_loads(rules.model, feed);
            }};
}

}  // namespace endmill
