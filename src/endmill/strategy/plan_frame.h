// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <Eigen/Core>

#include "endmill/cutter/cutter.h"
#include "endmill/strategy/strategy.h"
#include "endmill/surface/part.h"

/// \file
/// Plans by strategies along any tool axis: the part is rotated so that the axis becomes +z.

namespace endmill {

/// How the part stands while it is planned, and what the tool must not enter.
struct PlanFrame {
    /// Rotation of the part about its origin. The third row is the tool axis in the part.
    Eigen::Matrix3d part_to_machine = Eigen::Matrix3d::Identity();
    const Part* protected_part = nullptr;  ///< not rotated; null: none
};

/// Plans by a strategy, or by the best one, on the rotated part, and rotates the path back.
///
/// StrategyOptions::direction is an angle in the rotated frame, and the safe height is along
/// the tool axis. Path and uncovered places are returned in the coordinates of the part;
/// places of the deviations are those of the rotated part.
/// \param strategy nothing: the best one, for a ball.
/// \param part     not rotated.
/// \param options  `link.axis` and `protected_part` are replaced by those of the frame.
/// \throws DomainError for a matrix that is no rotation; as plan_by_strategy and
///         plan_by_best_strategy.
BestPlan plan_in_frame(const PlanFrame& frame, std::optional<Strategy> strategy,
                       const Part& part, const Cutter& cutter, StrategyOptions options);

}  // namespace endmill
