// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/setup/detail/rectangle_candidate.h"
#include "endmill/setup/setup_mode.h"
#include "endmill/setup/setup_pose.h"

namespace endmill {

/// The rectangles that `mode` tries for `directions`: one with a meridian through each edge of
/// the gnomonic hull; in `SetupMode::Corrected` then one with a parallel through each edge of
/// the orthographic hull. If all directions lie on one great circle through the tool axis, the
/// arc of it. None if a direction is 90 degrees or more (cosine below 1e-6) from the tool axis
/// and they do not lie on one. \pre the vectors have unit length.
std::vector<RectangleCandidate> rectangle_candidates(const Vec3& tool_axis,
                                                     std::span<const Vec3> directions,
                                                     SetupMode mode);

/// The rectangles of least area that hold the tool axis and `directions`, of all and of those
/// within limits. The mode decides which are tried, see `setup_rules`; `Corrected` is exact for
/// the given directions and tool axis: between neighbouring edges of the two hulls the area is
/// a log-concave function of R1's azimuth, and so least at an end, or where an extent meets a
/// limit (derived in paper/notes/rectangle-about-an-axis.md); with directions 90 degrees or
/// more from the tool axis, where that fails, to 1e-7 of F by branch and bound.
///
/// The pose takes the larger end of R1's range as the positive one, or the smaller if only that
/// fits; of equal ones that with the larger end of R2's.
/// Source: [KangSuh, section 6, eq. (15)–(21)].
/// \param tool_axis unit. \param directions unit. \param bounds spare work: a fit is missing
///        only if its area is larger, and any that is not is the one without bounds.
/// \return status `NoOpenHemisphere`, one pose skipped and no fit in the paper's modes if a
///         direction has a cosine below 1e-6 with the tool axis.
/// \throws DomainError as `check_setup_options`, or if the family is not A,B.
SetupSearch rectangle_fit(const Vec3& tool_axis, std::span<const Vec3> directions,
                          const SetupOptions& options, const AreaBounds& bounds = {});

/// Areas that `rectangle_fit` does not exceed, found with less work: infinite where it would
/// need none.
AreaBounds rectangle_bounds(const Vec3& tool_axis, std::span<const Vec3> directions,
                            const SetupOptions& options);

}  // namespace endmill
