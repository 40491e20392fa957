// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/deviation/part_charts.h"
#include "endmill/stock/detail/sweep_tree.h"

namespace endmill {

/// Returns a lower bound of the distance in mm between cutter and part, for a message; 0
/// if they may touch. The cutter is replaced by a ball of the same radius, and the
/// distance is measured from the middles of small pieces of the charts, minus the reach
/// of a piece.
/// \return infinity if there is no sweep or no chart.
/// \pre all sweeps have the same cutter; not checked.
double part_gap(const PartCharts& charts, const SweepTree& tree);

/// Whether the cutter passes over the part, seen from above, below a height `top` in mm.
/// It then cuts stock over the part, unless that is already removed. Charts are
/// subdivided where it may pass, down to 2^-12 of their sides; a narrower overlap is not
/// found.
/// \pre all sweeps have the same cutter; not checked.
bool passes_over(const PartCharts& charts, const SweepTree& tree, double top);

}  // namespace endmill
