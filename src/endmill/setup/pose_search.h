// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "endmill/core/vec.h"
#include "endmill/setup/setup_mode.h"
#include "endmill/setup/setup_pose.h"
#include "endmill/visibility/visibility.h"

namespace endmill {

/// How a part is to stand so that a machine's rotary axes need the least ranges for a given
/// set of directions, when `tool_axis` is the tool axis at zero: `sector_fit` or
/// `rectangle_fit`, by the family.
/// \throws DomainError as those, or unless all vectors have unit length, to 1e-6.
SetupSearch pose_fit(const Vec3& tool_axis, std::span<const Vec3> directions,
                     const SetupOptions& options, const AreaBounds& bounds = {});

/// The pose that needs the least ranges, of all whose tool axis is the centre of a cell. At
/// each the cone of a facet is represented by its cell nearest to the tool axis, see
/// `nearest_cells`. Best is the least area, then the least sum of the ranges, then the lowest
/// cell, then the first candidate; areas and sums count as equal within 1e-9. Facets that no
/// cell reaches are left out of account. In the paper's modes for A,B poses from which a
/// direction has a cosine below 1e-6 are skipped and counted.
///
/// Poses run in parallel; the result does not depend on the number of threads.
/// Source: [KangSuh, sections 4 to 6].
/// \param centres unit, one for each cell of `map`.
/// \return `least` and `feasible` are the unconstrained and the constrained minimum, and
///         `status` tells of the feasible one, or if there is none of the other.
/// \throws DomainError as `check_setup_options`, or unless there is a centre of unit length
///         for each cell.
SetupSearch setup_search(const VisibilityMap& map, std::span<const Vec3> centres,
                         const SetupOptions& options);

}  // namespace endmill
