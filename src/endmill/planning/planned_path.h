// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/path/tool_path.h"
#include "endmill/planning/planner_options.h"
#include "endmill/planning/verified_plan.h"
#include "endmill/surface/surface.h"

/// \file
/// Plans a path by either planner, and relates the number of points of a path to the
/// memory that planning and writing it needs.

namespace endmill {

/// The options of a planner. Their type selects plan_iso_parametric or plan_verified.
using PlannerOptions = std::variant<IsoParametricOptions, VerifiedOptions>;

/// A path by either planner.
struct PlannedPath {
    ToolPath path;  ///< all passes and the links between them
    /// Number of links that are lifted because a straight link would gouge; 0 by
    /// plan_iso_parametric, which does not test links.
    std::size_t lifted_links = 0;
    /// See VerifiedPlan; none by plan_iso_parametric, which proves nothing.
    std::optional<std::vector<UncoveredPlace>> uncovered = {};

    /// Whether the planner has proved that no gouge and no remaining stock anywhere
    /// exceeds the options.
    bool is_proved() const { return uncovered && uncovered->empty(); }
};

/// Plans a path by the planner of the options.
/// \param surfaces the part; at least one.
/// \param cutter   the ball.
/// \param options  of the planner.
/// \throws DomainError, GeometryError and LimitError as the planner.
PlannedPath plan_path(std::span<const Surface> surfaces, const BallCutter& cutter,
                      const PlannerOptions& options);

/// Estimates the number of points that plan_path returns. The sum of estimated_points of
/// the surfaces, by the chord tolerance or the smaller motion tolerance; it is right to a
/// factor of about two.
/// \param surfaces the part.
/// \param cutter   the ball.
/// \param options  of the planner.
/// \throws DomainError as plan_iso_parametric.
double estimated_points(std::span<const Surface> surfaces, const BallCutter& cutter,
                        const PlannerOptions& options);

/// Upper bound in bytes of the memory for each point of a path until its files are
/// written: the growing path and the text of one file.
inline constexpr double bytes_per_path_point = 1000;

/// The greatest number of path points for which `memory_gib` suffices.
/// \pre 0 <= memory_gib
std::size_t most_path_points(double memory_gib);

/// Refuses a path that is too long for `memory_gib` before it is planned. The estimated
/// number of points is right to a factor of two. A path is therefore refused only if half
/// of the estimate is already too many.
/// \param points     estimated number of points.
/// \param memory_gib available memory.
/// \throws LimitError with the number of points, the memory that they need and the limit.
void require_path_memory(double points, double memory_gib);

/// Whether several paths may be planned at the same time: together they need at most a
/// quarter of the memory, by their estimated numbers of points.
/// \param points     estimated number of points of each path.
/// \param memory_gib available memory.
/// \throws LimitError as require_path_memory if one path alone is too long.
bool fit_together(std::span<const double> points, double memory_gib);

}  // namespace endmill
