// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "endmill/planning/detail/economy_tables.h"
#include "endmill/planning/detail/table_search.h"

/// \file
/// What the interpretation of the tables by whole numbers implies if the surface is exactly
/// translational.

namespace endmill {

/// NCL - (f + b) N / 2 of the three balls of a row: zero if N is even and every pair of passes has
/// f + b points, half of f - b if N is odd. Other values mean that single passes differ.
struct Surplus {
    double low;
    double high;
};
Surplus surplus_points(const EconomyTables& printed, const DecodedTables& decoded,
                       int direction, int tolerance);

/// Largest over smallest product of printed TCD and interval on a plane of the three balls of a row, less
/// 1. With governing curvatures near zero the products are equal up to an interval in N.
/// \param ratio h / delta.
double interval_spread(const EconomyTables& printed, int direction, int tolerance,
                       double ratio);

/// Deviation of the TCD of the middle ball from the power law through the two others, in percent. On a
/// surface with governing curvatures near zero it is about what rounding the numbers of passes leaves, half a pass.
double middle_ball_deviation(const EconomyTables& tables, int direction, int tolerance);

/// The smallest contradiction in mm between the printed TCD and a translational surface with the decoded
/// numbers of passes: each row needs lengths L_f and L_b of its passes, at most the arc of their curve, and
/// links W = TCD - n_f L_f - n_b L_b between what the last pass leaves and the arc of the other curve.
/// The last pass leaves nothing (Border; up to 0.3 mm for chords), up to half of an interval (Half) or up
/// to one interval (None). An interval at the end may be `interval_factor` times the mean one. The arcs are
/// free, the same for all six rows. The contradiction is the largest excess over a bound; 0 if there is
/// none.
struct LinkContradiction {
    double excess_mm;
    double arc_u_mm;  ///< arcs with the smallest excess, to 0.5 mm
    double arc_v_mm;
};
LinkContradiction link_contradiction(const EconomyTables& printed,
                                     const DecodedTables& decoded, LastPath last_path,
                                     double interval_factor);

}  // namespace endmill
