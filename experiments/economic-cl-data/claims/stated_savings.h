// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/printed_tables.h"

namespace endmill {

/// The conclusions in the paper's text from its tables, as shares.
/// Source: [KimChoi, sections 6 and 7, abstract].
struct StatedSavings {
    double points_between_directions;   ///< mean of nine reductions of NCL: "about 25 %"
    double travel_between_directions;   ///< mean of nine reductions of TCD: "about 8 %"
    double points_at_finest_tolerance;  ///< mean of the three at 0.2 mm: "28 %"
    double by_diameter_along_v;         ///< mean of six, 10 to 20 mm: "about 29 %"
    bool larger_is_better;  ///< every row falls as the ball grows: "as large as possible"
};

/// Computes these means from `tables`.
StatedSavings stated_savings(const EconomyTables& tables);

}  // namespace endmill
