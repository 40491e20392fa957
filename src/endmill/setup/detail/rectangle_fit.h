// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/setup/detail/rectangle_candidate.h"
#include "endmill/setup/detail/setup_order.h"
#include "endmill/setup/setup_pose.h"

namespace endmill {

/// The rectangles that a mode tries. Each has a meridian through an edge of the gnomonic
/// hull, or, in `SetupMode::Corrected`, a parallel through an edge of the orthographic
/// hull. If all directions lie on one great circle through the tool axis, the only
/// candidate is its arc.
/// \param tool_axis unit. \param directions unit. \param mode decides which hulls are
///         used.
/// \return no candidate if a direction has a cosine below 1e-6 with the tool axis and the
///         directions do not lie on one great circle through it.
std::vector<RectangleCandidate> rectangle_candidates(const Vec3& tool_axis,
                                                     std::span<const Vec3> directions,
                                                     SetupMode mode);

/// Finds the rectangles of least area that contain the tool axis and given directions:
/// the least of all, and the least within the limits.
///
/// The mode decides which rectangles are tried; see `setup_rules`. `Corrected` is exact
/// for the given directions and tool axis. Between neighbouring edges of the two hulls
/// the area is a log-concave function of R1's azimuth, so that it is least at an end, or
/// where an extent meets a limit. Directions 90 degrees or more from the tool axis, where
/// this argument fails, are fitted by branch and bound, to 1e-7 of the area.
///
/// The pose is turned so that the larger end of R1's range is positive, or the other end
/// if only that fits the limits; if both ends are equal, so that the larger end of R2's
/// range is positive.
/// Source: [KangSuh, section 6, eq. (15)–(21)]; paper/notes/rectangle-about-an-axis.md,
/// sections 2 to 5.
/// \param tool_axis unit. \param directions unit. \param options mode and limits.
/// \param bounds save work: a fit is missing only if its area exceeds its bound, and the
///         result is otherwise the same as without bounds.
/// \return in the paper's modes, if a direction has a cosine below 1e-6 with the tool
///         axis: no fit, one pose skipped, and the status `NoOpenHemisphere`.
/// \throws DomainError as `check_pose_fit_options`, or if the family is not A,B.
PoseSearchResult rectangle_fit(const Vec3& tool_axis, std::span<const Vec3> directions,
                               const PoseFitOptions& options,
                               const AreaBounds& bounds = {});

/// Upper bounds of the areas that `rectangle_fit` finds, with less work.
/// \param tool_axis unit. \param directions unit. \param options mode and limits.
/// \return infinite bounds where `rectangle_fit` is fast anyway.
AreaBounds rectangle_bounds(const Vec3& tool_axis, std::span<const Vec3> directions,
                            const PoseFitOptions& options);

}  // namespace endmill
