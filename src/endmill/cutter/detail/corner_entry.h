// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "endmill/core/answer.h"
#include "endmill/cutter/detail/line.h"

namespace endmill {

/// Result of a search from outside for the entry of a line.
struct CornerApproach {
    Answer enters;                    ///< whether the line enters before the given place
    std::optional<SweepEntry> entry;  ///< given exactly if the answer is Yes
};

/// Where a line enters the region that a bull-nose cutter clears on a move, found from
/// outside by half spaces that contain the whole region.
///
/// The region is everything above some point within the corner radius r of the core. The
/// core is the disc of radius R - r inside the circle of corner centres, swept along the
/// move.
/// 1. Take a place of the line and a place of the move, and the nearest point of the disc
///    there. The plane across the connection, moved out to where disc, move and r end,
///    has the whole region on its far side. So the line is outside up to where it crosses
///    it.
/// 2. A place within r of the core is in the region.
/// 3. Newton's method improves the place on the line and the place of the move together,
///    until the bounds of steps 1 and 2 meet within rounding.
/// Source: paper/notes/swept-cutter.md, section 7.
///
/// \param before place on the line, in mm; later entries are not reported.
/// \return undecided where the iteration does not converge: mostly for lines that come
///         from above or graze the region.
/// \pre the cutter is a bull-nose.
CornerApproach corner_approach(const StraightSweep& sweep, const Line& line,
                               double before);

/// `sweep_entry` for a bull-nose cutter: by `corner_approach`, and where that is
/// undecided by tangents to the height S over the line, which is a convex function.
std::optional<SweepEntry> corner_entry(const StraightSweep& sweep, const Line& line,
                                       double before);

}  // namespace endmill
