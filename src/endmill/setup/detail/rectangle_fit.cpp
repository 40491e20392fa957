// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/rectangle_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/setup/detail/pole_points.h"
#include "endmill/setup/detail/rectangle_branch.h"
#include "endmill/setup/detail/rectangle_edges.h"
#include "endmill/setup/detail/setup_order.h"

namespace endmill {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// What is asked, in alpha and beta about R1 and R2 = C x R1.
struct Question {
    const SetupRules& rules;
    RotaryLimits limits;
    bool is_b_first;

    explicit Question(const SetupOptions& options)
        : rules{setup_rules(options.mode)},
          limits{options.limits},
          is_b_first{options.is_b_first}
    {
        if (is_b_first)
            limits.theta = turned(limits.theta);
    }

    bool is_limited() const { return limits != RotaryLimits{}; }

    // [KangSuh, eq. (20)]
    bool fits_unsigned(const RectangleCandidate& rectangle) const
    {
        return is_within_unsigned(rectangle.alpha, limits.phi) &&
               is_within_unsigned(rectangle.beta, limits.theta);
    }

    bool is_feasible(const RectangleCandidate& rectangle) const
    {
        return rules.has_signed_limits ? fits_rigidly(rectangle, limits)
                                       : fits_unsigned(rectangle);
    }
};

struct BestRectangles {
    std::optional<RectangleCandidate> least;
    std::optional<RectangleCandidate> feasible;
};

// Whether R1 is to be reversed, and the part turned by 180 degrees about the tool axis.
bool is_turn_better(const RectangleCandidate& rectangle, const RotaryLimits& limits)
{
    const RotaryRange& alpha = rectangle.alpha;
    const RotaryRange& beta = rectangle.beta;
    const bool fits = is_within(alpha, limits.phi) && is_within(beta, limits.theta);
    const bool fits_turned =
        is_within(turned(alpha), limits.phi) && is_within(turned(beta), limits.theta);
    if (fits != fits_turned)
        return fits_turned;
    if (std::abs(alpha.to + alpha.from) > equal_angles)
        return alpha.to < -alpha.from;
    return beta.to < -beta.from - equal_angles;
}

FittedPose fitted_pose(const Vec3& tool_axis, const RectangleCandidate& rectangle,
                       const Question& question)
{
    const bool is_turned = is_turn_better(rectangle, question.limits);
    const Vec3 r1 = is_turned ? Vec3{-rectangle.r1_axis} : rectangle.r1_axis;
    const Vec3 r2 = tool_axis.cross(r1);
    FittedPose fit;
    fit.phi = is_turned ? turned(rectangle.alpha) : rectangle.alpha;
    fit.theta =
        is_turned != question.is_b_first ? turned(rectangle.beta) : rectangle.beta;
    fit.pose = {tool_axis, r1, question.is_b_first ? Vec3{-r2} : r2};
    fit.area = rectangle.area();
    fit.is_rigid =
        !question.fits_unsigned(rectangle) || fits_rigidly(rectangle, question.limits);
    return fit;
}

BestRectangles best_of(const std::vector<RectangleCandidate>& candidates,
                       const Question& question, const AreaBounds& bounds)
{
    BestCandidate<RectangleCandidate> least{bounds.least};
    BestCandidate<RectangleCandidate> feasible{bounds.feasible};
    for (const RectangleCandidate& rectangle : candidates) {
        const SetupScore score{rectangle.area(), rectangle.sum()};
        least.offer(rectangle, score);
        if (feasible.wants(score.area) && question.is_feasible(rectangle))
            feasible.offer(rectangle, score);
    }
    return {least.best(), feasible.best()};
}

BestRectangles best_at_edges(const PolePoints& points, std::span<const Vec3> directions,
                             SetupMode mode, const Question& question,
                             const AreaBounds& bounds)
{
    const RectangleImages images{points, directions, mode};
    std::vector<RectangleCandidate> candidates = images.at_edges();
    BestRectangles best = best_of(candidates, question, bounds);
    if (question.rules.has_both_hulls && question.is_limited()) {
        const auto limiting = images.at_limits(question.limits);
        candidates.insert(candidates.end(), limiting.begin(), limiting.end());
        best.feasible = best_of(candidates, question, bounds).feasible;
    }
    return best;
}

// Within limits it is searched for apart from the other, even where that one fits: whether the
// other is found depends on its own bound.
BestRectangles best_by_branching(const PolePoints& points, const Question& question,
                                 const AreaBounds& bounds)
{
    BestRectangles best;
    best.least = branch_rectangle(points, {std::nullopt, bounds.least});
    best.feasible = question.is_limited()
                        ? branch_rectangle(points, {question.limits, bounds.feasible})
                        : best.least;
    return best;
}

// No search that may find the rectangle ends above.
double search_limit(const std::optional<RectangleCandidate>& rectangle)
{
    if (!rectangle)
        return infinity;
    const double area = rectangle->area();
    return area + 2 * branch_accuracy * std::max(area, square_degree);
}

}  // namespace

std::vector<RectangleCandidate> rectangle_candidates(const Vec3& tool_axis,
                                                     std::span<const Vec3> directions,
                                                     SetupMode mode)
{
    const PolePoints points{tool_axis, directions};
    if (const std::optional<RectangleCandidate> arc = great_circle_arc(points))
        return {*arc};
    if (has_low_direction(points))
        return {};
    return RectangleImages{points, directions, mode}.at_edges();
}

SetupSearch rectangle_fit(const Vec3& tool_axis, std::span<const Vec3> directions,
                          const SetupOptions& options, const AreaBounds& bounds)
{
    check_setup_options(options);
    require(options.family == RotaryFamily::AB, "rectangle_fit: need the family A,B");
    const Question question{options};
    const PolePoints points{tool_axis, directions};
    const bool is_low = has_low_direction(points);
    SetupSearch result;
    result.poses_tried = 1;
    if (is_low && !question.rules.takes_low_directions) {
        result.poses_skipped = 1;
        result.status = SetupStatus::NoOpenHemisphere;
        return result;
    }
    BestRectangles best;
    if (const std::optional<RectangleCandidate> arc = great_circle_arc(points))
        best = best_of({*arc}, question, bounds);
    else if (is_low)
        best = best_by_branching(points, question, bounds);
    else
        best = best_at_edges(points, directions, options.mode, question, bounds);
    if (best.least)
        result.least = fitted_pose(tool_axis, *best.least, question);
    if (best.feasible)
        result.feasible = fitted_pose(tool_axis, *best.feasible, question);
    if (const std::optional<FittedPose>& shown =
            result.feasible ? result.feasible : result.least)
        result.status = status_of(*shown);
    return result;
}

AreaBounds rectangle_bounds(const Vec3& tool_axis, std::span<const Vec3> directions,
                            const SetupOptions& options)
{
    const Question question{options};
    const PolePoints points{tool_axis, directions};
    if (!question.rules.takes_low_directions || !has_low_direction(points))
        return {};
    const double least = search_limit(coarse_rectangle(points, {}));
    if (!question.is_limited())
        return {least, least};
    return {least, search_limit(coarse_rectangle(points, {question.limits}))};
}

}  // namespace endmill
