// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/process/detail/stroke_forces.h"
#include "support/named_cells.h"

namespace endmill {

/// Measures of the forces along a path at one feed. Variations are coefficients of
/// variation over the length.
struct FeedMeasures {
    double shallow_force_n;          ///< largest true force near the top of the stock
    double force_n;                  ///< largest true force
    double force_variation;          ///< of the true peaks
    double stated_force_variation;   ///< of the force by eq. (15)
    double stated_thrust_variation;  ///< of the thrust by eq. (16)
    double capacity_used;  ///< mean of the larger of force and thrust over their limits
    double used_life;      ///< share of the tool life
};

/// What the measures of a path depend on.
struct MeasureRules {
    double shallow_mm;   ///< depth below which a move is near the top
    double life_min;     ///< T0 of the tool-life equation
    double peak_factor;  ///< R_m
};

/// Measures of moves. True forces are those of the turning flutes.
FeedMeasures feed_measures(const std::vector<MilledMove>& moves, const MillingJob& job,
                           const MeasureRules& rules);

/// A claim of the conclusions 4 and 5 or of the abstract, and the name of its column.
/// Source: [ParkMaeng, section 6].
struct FeedClaim {
    std::string name;
    bool (*holds)(const FeedMeasures& constant, const FeedMeasures& varied);
};

/// The claims: shallow_force_falls, largest_force_falls, force_disperses,
/// stated_force_disperses, stated_thrust_disperses, capacity_rises, used_life_falls.
const std::vector<FeedClaim>& feed_claims();

/// Columns of the result.
std::vector<std::string> measure_columns();

/// The measures as cells.
NamedCells measure_cells(const FeedMeasures& measures);

}  // namespace endmill
