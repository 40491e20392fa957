// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/surface/surface_jet.h"
#include "support/experiment.h"

namespace endmill {

/// Range of t(100 planes) / t(50 planes) that counts as proportional to the planes.
inline constexpr Interval proportional_ratio{1.7, 2.3};

/// Adds the rows of one feed: the times of each method of params.json at all planes and
/// at half of them, and the fastest of the methods in the paper.
void add_measured(Experiment& run, CsvTable& result, double feed_deg);

}  // namespace endmill
