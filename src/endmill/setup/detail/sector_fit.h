// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/setup/setup_mode.h"
#include "endmill/setup/setup_pose.h"

namespace endmill {

/// Two opposite sectors about a tool axis that hold given directions: what a machine of family
/// C,A reaches when C turns by `width`. Source: [KangSuh, eq. (6)–(11), (13)].
struct SectorCandidate {
    double from;   ///< rad: azimuth at which the first sector begins
    double width;  ///< rad, within [0, 2 pi): its azimuths are [from, from + width]
    double polar;  ///< rad: largest polar angle in it
    double opposite_polar;  ///< rad: of the directions that it does not hold

    double area() const { return (polar + opposite_polar) * width; }  ///< rad^2, F
};

/// The sectors with an end at a direction, one after each direction in the order of their
/// azimuths, less than 180 degrees wide; in `SetupMode::Corrected` then those wider, from each
/// direction to each other that lies 180 degrees or more on. Azimuths are those of `PoleFrame`,
/// from x if the tool axis is +Z. Directions along the tool axis are in all of them.
/// O(n^2). \pre the vectors have unit length.
std::vector<SectorCandidate> sector_candidates(const Vec3& tool_axis,
                                               std::span<const Vec3> directions,
                                               SetupMode mode);

/// The sectors of least area that hold `directions`, of all and of those within limits. Exact
/// for the given directions and tool axis in `SetupMode::Corrected`, in the other modes among
/// sectors of less than 180 degrees.
///
/// The pose takes for the positive tilt the sector of the larger angle, or the other one if
/// only that fits, and spreads its azimuths over the limits of C in their ratio, so that both
/// ends keep the same share of room. Source: [KangSuh, section 5, eq. (5)–(13)].
/// \param tool_axis unit. \param directions unit. \param bounds spare work; a fit of a larger
///        area may be missing.
/// \throws DomainError as `check_setup_options`, or if the family is not C,A.
SetupSearch sector_fit(const Vec3& tool_axis, std::span<const Vec3> directions,
                       const SetupOptions& options, const AreaBounds& bounds = {});

}  // namespace endmill
