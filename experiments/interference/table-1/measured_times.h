// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/experiment.h"

namespace endmill {

/// Adds the rows of one feed: the times of each method of params.json at all planes and
/// at half of them, and the fastest of the methods in the paper.
void add_measured(Experiment& run, CsvTable& result, double feed_deg);

}  // namespace endmill
