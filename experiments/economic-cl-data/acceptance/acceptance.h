// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>

#include "endmill/planning/detail/economy_scaling.h"
#include "endmill/surface/largest_cutter.h"

namespace endmill {

/// Scallops between governing points and their partners over all 18 runs, as shares of
/// the requested scallop height.
struct CuspCheck {
    ValueRange pairs;     ///< over all passes of all runs
    double worst_median;  ///< largest |median of a run - 1|
};

/// Measures the scallops of all 18 runs on `surface` by `scallop_between`.
CuspCheck check_cusps(const Surface& surface);

/// Properties of the printed tables that a surface should reproduce, with some margin, so
/// that the planner can be taken for the paper's.
struct Acceptance {
    CutterLimit limit;     ///< largest cutter of the surface
    EconomyTables tables;  ///< planned on the surface
    CuspCheck cusps;

    /// The exponent of TCD in the tolerance lies in [-0.53, -0.46].
    bool travel_falls_with_root_of_tolerance() const;
    /// The exponent of NCL in the tolerance lies in [-1.06, -0.94].
    bool points_fall_with_tolerance() const;
    /// The exponents of both in the radius lie in [-0.54, -0.46].
    bool both_fall_with_root_of_radius() const;
    /// Doubling the ball saves 27 to 31 % in all twelve rows.
    bool doubling_the_ball_saves() const;
    /// The mean segment varies with the ball by at most 2.5 %.
    bool segments_depend_on_tolerance_only() const;
    /// All cells within 4 % of the print; v costs less everywhere, by 20 to 31 % of the
    /// points and 3 to 13 % of the travel.
    bool cells_are_near(const EconomyTables& printed) const;
    /// The median scallop of each run is within 1 % of the requested height.
    bool cusps_are_as_asked() const;
};

/// Plans all runs on `surface` and measures the properties.
Acceptance acceptance_of(const Surface& surface);

}  // namespace endmill
