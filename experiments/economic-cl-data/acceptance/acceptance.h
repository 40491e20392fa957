// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>

#include "endmill/planning/detail/economy_scaling.h"
#include "endmill/surface/largest_cutter.h"

namespace endmill {

/// The cusps between governing points and their partners over all 18 runs, as shares of
/// the scallop height asked for.
struct CuspCheck {
    ValueRange pairs;     ///< over all passes of all runs
    double worst_median;  ///< greatest |median of a run - 1|
};

/// Cusps by scallop_between for all 18 runs on `surface`.
CuspCheck check_cusps(const Surface& surface);

/// What a surface must have in common with the printed tables for the planner to count as
/// the paper's: the properties that the printed cells have themselves, with some room.
struct Acceptance {
    CutterLimit limit;     ///< of the surface
    EconomyTables tables;  ///< planned on it
    CuspCheck cusps;

    /// TCD by the tolerance, in [-0.53, -0.46].
    bool travel_falls_with_root_of_tolerance() const;
    /// NCL by the tolerance, in [-1.06, -0.94].
    bool points_fall_with_tolerance() const;
    /// Both by the radius, in [-0.54, -0.46].
    bool both_fall_with_root_of_radius() const;
    /// A ball of twice the size saves 29 % within 2 % in all twelve rows.
    bool doubling_the_ball_saves() const;
    /// The mean segment depends on the ball by 2.5 % at most.
    bool segments_depend_on_tolerance_only() const;
    /// All cells within 4 % of the print; v costs less everywhere, by 20 to 31 % of the
    /// points and 3 to 13 % of the travel.
    bool cells_are_near(const EconomyTables& printed) const;
    /// The median cusp of each run is the scallop height within 1 %.
    bool cusps_are_as_asked() const;
};

/// Plans all runs on `surface` and measures it.
Acceptance acceptance_of(const Surface& surface);

}  // namespace endmill
