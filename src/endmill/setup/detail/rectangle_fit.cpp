// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/rectangle_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/tolerance.h"
#include "endmill/setup/detail/pole_points.h"
#include "endmill/setup/detail/rectangle_branch.h"
#include "endmill/setup/detail/rectangle_edges.h"
#include "endmill/setup/detail/setup_rules.h"

namespace endmill {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The rules and limits of a fit, in alpha and beta about R1 and R2 = C x R1.
struct RectangleProblem {
    const SetupRules& rules;
    RotaryLimits limits;
    RotaryOrder order;

    explicit RectangleProblem(const PoseFitOptions& options)
        : rules{setup_rules(options.mode)},
          limits{options.limits},
          order{options.order}
    {
        if (order == RotaryOrder::BFirst)
            limits.theta = turned(limits.theta);
    }

    bool is_limited() const { return limits != RotaryLimits{}; }

    // Source: [KangSuh, eq. (20)].
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

// Tests whether the part should be turned by 180 degrees about the tool axis, which
// reverses R1.
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
                       const RectangleProblem& problem)
{
    const bool is_turned = is_turn_better(rectangle, problem.limits);
    const bool is_b_first = problem.order == RotaryOrder::BFirst;
    const Vec3 r1 = is_turned ? Vec3{-rectangle.r1_axis} : rectangle.r1_axis;
    const Vec3 r2 = tool_axis.cross(r1);
    FittedPose fit;
    fit.phi = is_turned ? turned(rectangle.alpha) : rectangle.alpha;
    fit.theta = is_turned != is_b_first ? turned(rectangle.beta) : rectangle.beta;
    fit.pose = {tool_axis, r1, is_b_first ? Vec3{-r2} : r2};
    fit.area = rectangle.area();
    fit.is_rigid =
        !problem.fits_unsigned(rectangle) || fits_rigidly(rectangle, problem.limits);
    return fit;
}

BestRectangles best_of(const std::vector<RectangleCandidate>& candidates,
                       const RectangleProblem& problem, const AreaBounds& bounds)
{
    BestCandidate<RectangleCandidate> least{bounds.least};
    BestCandidate<RectangleCandidate> feasible{bounds.feasible};
    for (const RectangleCandidate& rectangle : candidates) {
        const SetupScore score{rectangle.area(), rectangle.sum()};
        least.offer(rectangle, score);
        if (feasible.wants(score.area) && problem.is_feasible(rectangle))
            feasible.offer(rectangle, score);
    }
    return {least.best(), feasible.best()};
}

BestRectangles best_at_edges(const PolePoints& points, std::span<const Vec3> directions,
                             SetupMode mode, const RectangleProblem& problem,
                             const AreaBounds& bounds)
{
    const RectangleImages images{points, directions, mode};
    std::vector<RectangleCandidate> candidates = images.at_edges();
    BestRectangles best = best_of(candidates, problem, bounds);
    if (problem.rules.has_both_hulls && problem.is_limited()) {
        const auto limiting = images.at_limits(problem.limits);
        candidates.insert(candidates.end(), limiting.begin(), limiting.end());
        best.feasible = best_of(candidates, problem, bounds).feasible;
    }
    return best;
}

// Both rectangles are searched for separately, even if the least one fits the limits.
// Otherwise the bound of the least one would decide whether the feasible one is found.
BestRectangles best_by_branching(const PolePoints& points,
                                 const RectangleProblem& problem,
                                 const AreaBounds& bounds)
{
    BestRectangles best;
    best.least = branch_rectangle(points, {std::nullopt, bounds.least});
    best.feasible = problem.is_limited()
                        ? branch_rectangle(points, {problem.limits, bounds.feasible})
                        : best.least;
    return best;
}

// An upper bound of the area that a search finds if this rectangle exists.
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

PoseSearchResult rectangle_fit(const Vec3& tool_axis, std::span<const Vec3> directions,
                               const PoseFitOptions& options, const AreaBounds& bounds)
{
    check_pose_fit_options(options);
    require(options.family == RotaryFamily::AB, "rectangle_fit: need the family A,B");
    const RectangleProblem problem{options};
    const PolePoints points{tool_axis, directions};
    const bool is_low = has_low_direction(points);
    PoseSearchResult result;
    result.poses_tried = 1;
    if (is_low && !problem.rules.takes_low_directions) {
        result.poses_skipped = 1;
        result.status = SetupStatus::NoOpenHemisphere;
        return result;
    }
    BestRectangles best;
    if (const std::optional<RectangleCandidate> arc = great_circle_arc(points))
        best = best_of({*arc}, problem, bounds);
    else if (is_low)
        best = best_by_branching(points, problem, bounds);
    else
        best = best_at_edges(points, directions, options.mode, problem, bounds);
    if (best.least)
        result.least = fitted_pose(tool_axis, *best.least, problem);
    if (best.feasible)
        result.feasible = fitted_pose(tool_axis, *best.feasible, problem);
    if (const std::optional<FittedPose>& shown =
            result.feasible ? result.feasible : result.least)
        result.status = status_of(*shown);
    return result;
}

AreaBounds rectangle_bounds(const Vec3& tool_axis, std::span<const Vec3> directions,
                            const PoseFitOptions& options)
{
    const RectangleProblem problem{options};
    const PolePoints points{tool_axis, directions};
    if (!problem.rules.takes_low_directions || !has_low_direction(points))
        return {};
    const double least = search_limit(coarse_rectangle(points, {}));
    if (!problem.is_limited())
        return {least, least};
    return {least, search_limit(coarse_rectangle(points, {problem.limits}))};
}

}  // namespace endmill
