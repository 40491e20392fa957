// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/setup/detail/direction_fan.h"
#include "endmill/setup/detail/setup_order.h"
#include "endmill/setup/setup_pose.h"

namespace endmill {

/// The double sectors that a mode tries. First those below 180 degrees, one for each
/// direction in the order of azimuths: the direction is the counter-clockwise end of the
/// first sector. In `SetupMode::Corrected` then wider ones, from each direction to each
/// direction 180 degrees or more further on. Directions along the tool axis lie in every
/// sector. O(n^2).
/// \param tool_axis unit. \param directions unit. \param mode decides on wide sectors.
/// \return sectors with azimuths in `PoleFrame`.
std::vector<SectorCandidate> sector_candidates(const Vec3& tool_axis,
                                               std::span<const Vec3> directions,
                                               SetupMode mode);

/// Finds the double sectors of least area that contain given directions: the least of
/// all, and the least within the limits. `SetupMode::Corrected` is exact for the given
/// directions and tool axis, the other modes among sectors below 180 degrees.
///
/// The sector of the larger polar angle gets the positive tilt, or the other one if only
/// that fits the limits. Zero of C divides the azimuths in the ratio in which it divides
/// the limits of C.
/// Source: [KangSuh, section 5, eq. (5)–(13)]; docs/methods/five-axis-setup.md,
/// section 5. O(n log n).
/// \param tool_axis unit. \param directions unit. \param options mode and limits.
/// \param bounds save work: a fit whose area exceeds its bound may be missing.
/// \throws DomainError as `check_pose_fit_options`, or if the family is not C,A.
PoseSearchResult sector_fit(const Vec3& tool_axis, std::span<const Vec3> directions,
                            const PoseFitOptions& options, const AreaBounds& bounds = {});

}  // namespace endmill
