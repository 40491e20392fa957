// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/simulation/deviation.h"

namespace endmill {

/// How much of the part has how much left on it, as a CSV file with the columns `from_mm`,
/// `to_mm` and `area_mm2`.
///
/// Bins have the width (scallop limit + tolerance) / 100 and go from -2 tolerances to 2
/// scallop limits; beyond it all is in the outermost. Rows are those from the least to the
/// greatest value, where the first begins and the last ends. A value between two bins is
/// in the upper one. The areas sum to `area_mm2` within rounding.
/// \throws DomainError unless both limits are finite and positive, and the deviation has
///         a finite value and area for each cell.
std::string deviation_histogram_csv(const Deviation& deviation,
                                    const DeviationLimits& limits);

}  // namespace endmill
