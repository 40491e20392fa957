// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "endmill/cutter/detail/sweep_entry.h"

namespace endmill {

/// What is known of a line and the region that a bull-nose cutter clears on a move.
struct CornerApproach {
    bool is_known;  ///< whether the search came to an end; if not, `entry` tells nothing
    std::optional<SweepEntry> entry;  ///< the first below `before`; none if there is none
};

/// The entry of a line, found from outside by half spaces that hold the whole region.
///
/// The region is all that lies above some point within the corner radius r of the core:
/// the disc of radius R - r inside the corner's circle, swept along the move. The plane
/// square to the way from a place of the line to any point of the core, moved out to where
/// the disc, the move and r end, has the region beyond it: the line is outside up to where
/// it crosses that plane. A place within r of the core is in the region. Newton's
/// iteration improves the place on the line and the share of the move at which the core is
/// nearest together, until both sides meet within rounding.
/// Source: derived in paper/notes/swept-cutter.md.
///
/// \pre the cutter is a bull-nose.
CornerApproach corner_approach(const StraightSweep& sweep, const Line& line,
                               double before);

}  // namespace endmill
