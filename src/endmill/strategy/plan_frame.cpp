// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/plan_frame.h"

#include <memory>
#include <utility>

#include <Eigen/LU>

#include "endmill/core/error.h"
#include "endmill/verification/verification.h"

namespace endmill {
namespace {

// A rotation may be off by this, the rounding of numbers in files.
constexpr double rotation_rounding = 1e-6;

bool is_rotation(const Eigen::Matrix3d& matrix)
{
    const Eigen::Matrix3d off = matrix * matrix.transpose() - Eigen::Matrix3d::Identity();
    return off.cwiseAbs().maxCoeff() <= rotation_rounding && matrix.determinant() > 0;
}

BestPlan planned(std::optional<Strategy> strategy, const Part& part, const Cutter& cutter,
                 const StrategyOptions& options)
{
    if (strategy)
        return {plan_by_strategy(*strategy, part, cutter, options), {}};
    require(cutter.is_ball(), "plan_in_frame: the best strategy needs a ball");
    return plan_by_best_strategy(part, BallCutter{cutter.radius()}, options);
}

// The path in the coordinates of the part. All points have exactly the given axis.
ToolPath turned_back(const ToolPath& path, const Eigen::Matrix3d& machine_to_part,
                     const Vec3& axis)
{
    ToolPath result = turned(path, machine_to_part);
    for (PathPoint& point : result.points)
        point.location.axis = axis;
    return result;
}

}  // namespace

BestPlan plan_in_frame(const PlanFrame& frame, std::optional<Strategy> strategy,
                       const Part& part, const Cutter& cutter, StrategyOptions options)
{
    const Eigen::Matrix3d& rotation = frame.part_to_machine;
    require(is_rotation(rotation), "plan_in_frame: need a rotation");
    options.link.axis = Vec3::UnitZ();
    const bool is_turned = rotation != Eigen::Matrix3d::Identity();
    std::optional<Part> guard;
    if (frame.protected_part && is_turned)
        guard = turned(*frame.protected_part, rotation);
    if (frame.protected_part)
        options.protected_part = std::make_shared<const ProtectedPart>(
            guard ? *guard : *frame.protected_part, BallCutter{cutter.radius()},
            options.inner_tolerance);
    if (!is_turned)
        return planned(strategy, part, cutter, options);
    BestPlan best = planned(strategy, turned(part, rotation), cutter, options);
    const Eigen::Matrix3d back = rotation.transpose();
    CoveringPath& covering = best.plan.covering;
    covering.path = turned_back(covering.path, back, back.col(2).normalized());
    for (UncoveredPlace& place : covering.uncovered)
        place.point = back * place.point;
    return best;
}

}  // namespace endmill
