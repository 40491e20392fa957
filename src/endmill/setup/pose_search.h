// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/setup/setup_pose.h"
#include "endmill/visibility/visibility.h"

/// \file
/// The paper's search for a setup: every cell centre is tried as the tool axis, and the
/// cone of each facet is represented by its cell nearest to this axis.

namespace endmill {

/// Fits the least ranges of the rotary axes to given directions at a given tool axis:
/// sectors for C,A, a rectangle for A,B.
/// Source: [KangSuh, sections 5, 6].
/// \param tool_axis unit. \param directions unit, from the part towards the spindle.
/// \param options family, mode and limits; `progress` is not called.
/// \return one tool axis tried; `least` and `feasible` as in `pose_search`.
/// \throws DomainError as `check_pose_fit_options`, or if a vector does not have unit
///         length to 1e-6.
PoseSearchResult pose_fit(const Vec3& tool_axis, std::span<const Vec3> directions,
                          const PoseFitOptions& options);

/// Finds the pose of least area among all poses whose tool axis is the centre of a cell.
///
/// 1. At each tool axis `nearest_cells` represents the cone of each facet by one cell.
///    Facets that no cell reaches are left out.
/// 2. `pose_fit` finds the least area for these cells.
/// 3. The pose of least area is chosen; among equal areas the one with the least sum of
///    both ranges, then with the lowest cell, then the first candidate. Areas and sums
///    are equal if they differ by at most 1e-9.
///
/// In the paper's modes for A,B, a tool axis is skipped and counted if the cosine of its
/// angle with a direction is below 1e-6. Tool axes run in parallel; the result does not
/// depend on the number of threads.
/// Source: [KangSuh, sections 4 to 6].
/// \param map cones of the facets. \param centres unit, one for each cell of `map`.
/// \param options family, mode, limits and progress.
/// \return `least` without and `feasible` within the limits; each is searched for on its
///         own.
/// \throws DomainError as `check_pose_fit_options`, or if there is not one centre of unit
///         length for each cell.
PoseSearchResult pose_search(const VisibilityMap& map, std::span<const Vec3> centres,
                             const PoseFitOptions& options);

/// The pose of least area within the limits at each tool axis, as `pose_search` fits it
/// there. All tool axes are fitted, which takes longer than the search for the best one.
/// \param map, centres, options as for `pose_search`.
/// \return in the order of cells; a tool axis without a pose within the limits is left
///         out.
/// \throws DomainError as `pose_search`.
std::vector<FittedPose> poses_within_limits(const VisibilityMap& map,
                                            std::span<const Vec3> centres,
                                            const PoseFitOptions& options);

}  // namespace endmill
