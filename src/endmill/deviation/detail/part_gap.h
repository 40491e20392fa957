// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/deviation/detail/part_cell.h"
#include "endmill/stock/detail/sweep_tree.h"

namespace endmill {

/// About how far in mm the cutter stays from the part: from the middles of its charts to
/// the nearest place of a cutter taken for a ball as wide as it, less what the charts
/// extend around their middles; 0 if they touch. For a message; never more than it is.
/// Infinite if there is no sweep or no chart.
/// \pre the sweeps are of one cutter, here and below; not checked.
double part_gap(const PartCharts& charts, const SweepTree& tree);

/// Whether a cutter passes over the part, as seen from above, below a stock's `top`, in mm:
/// then it takes something there, unless this is gone. Found by looking closer where it
/// may, down to 2^-12 of a chart; what is narrower is none.
bool passes_over(const PartCharts& charts, const SweepTree& tree, double top);

}  // namespace endmill
