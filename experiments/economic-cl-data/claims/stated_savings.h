// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "support/printed_tables.h"

namespace endmill {

/// The conclusions in the paper's text from its tables, as shares.
/// Source: [KimChoi, sections 6 and 7, abstract].
struct StatedSavings {
    double points_between_directions;   ///< mean of nine reductions of NCL: "about 25 %"
    double travel_between_directions;   ///< mean of nine reductions of TCD: "about 8 %"
    double points_at_finest_tolerance;  ///< mean of the three at 0.2 mm: "28 %"
    double by_diameter_along_v;         ///< mean of six, 10 to 20 mm: "about 29 %"
    double by_diameter;                 ///< mean of twelve, u and v: "about 29 %"
    double least_points_between_directions;  ///< least of the nine reductions of NCL
    double least_travel_between_directions;  ///< least of the nine reductions of TCD
    bool larger_is_better;  ///< every row falls as the ball grows: "as large as possible"
    bool v_beats_u;         ///< v costs less in all 18 pairs
};

/// Computes these means from `tables`.
StatedSavings stated_savings(const EconomyTables& tables);

/// The columns between which the last column of the printed tables is the reduction: "diameter A, B" for
/// the only two diameters whose reductions along v round to its six percentages; "none" or "several" if
/// there is no such pair or more than one. The print calls them "radius 10, 20".
std::string columns_of_last_column(const EconomyTables& printed);

}  // namespace endmill
