// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/process/detail/stroke_forces.h"

namespace endmill {

/// Peak loads of each move as the paper's limits state them: R_m times the means, with
/// the paper's chip and the paper's form of the force; 0 for a move in air.
/// Source: [ParkMaeng, eq. (15) to (17)].
/// \param peak_factor R_m.
std::vector<CuttingLoads> stated_loads(const std::vector<MilledMove>& moves,
                                       const MillingJob& job, double peak_factor);

/// The forces across the axis, or along it, of a list of loads.
std::vector<double> cutting_forces(const std::vector<CuttingLoads>& loads);
std::vector<double> thrusts(const std::vector<CuttingLoads>& loads);  ///< see above

}  // namespace endmill
