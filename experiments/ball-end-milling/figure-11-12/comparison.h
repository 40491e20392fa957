// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "support/milling_jobs.h"
#include "support/named_cells.h"

namespace endmill {

/// Columns of `add_comparison`.
std::vector<std::string> comparison_columns();

/// Variation of geometry and feed along a path and along the path REF: rows "NAME" and
/// "test surface", each with and without the leftover pass, and rows "NAME over test
/// surface" with the quotients. The leftover pass is the second one, which is narrower
/// than the others because the places of the passes are counted from the last one.
/// \return quantiles of the feed over the length: row, share_percent, feed_mm_per_min,
///         path ("NAME" or "test surface").
CsvTable add_comparison(CsvTable& table, const std::string& name,
                        const OneWayPasses& plan, const MillingJob& job,
                        const FeedPlanOptions& options);

}  // namespace endmill
