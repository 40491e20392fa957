// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/process/feed_plan.h"
#include "support/named_cells.h"

namespace endmill {

/// The times and the length that Park and Maeng print. Lists are in the order aluminium,
/// steel.
/// Source: [ParkMaeng, section 5].
struct PrintedTimes {
    std::vector<std::string> materials;
    double length_mm;                       ///< of the CL path
    std::vector<double> feeds_mm_per_min;   ///< constant feeds
    std::vector<double> constant_feed_min;  ///< total times at these feeds
    std::vector<double> variable_feed_min;  ///< total times at the varied feed
    double rounding_min;                    ///< largest rounding error of a printed time
};

/// Columns of the table of times: row, those that `add_accounts` fills, and those of
/// `limit_cells` and `limit_claims`.
std::vector<std::string> time_columns();

/// Adds the consequences of the printed numbers: length and non-cutting time from the two
/// constant feeds, non-cutting time from each feed and the length, totals at these feeds
/// with `noncut_min`, savings and cutting times; each with the range that the rounding of
/// the times allows. Fills the columns length_mm to greatest of `time_columns`.
/// Source: docs/methods/ball-end-milling.md, section 8.
void add_accounts(CsvTable& table, const PrintedTimes& printed, double noncut_min);

/// Shares of the limits that the largest torque and the largest power of a plan use:
/// torque_used and power_used.
NamedCells machine_cells(const FeedPlan& plan, const MillingJob& job);

/// off_60_percent: difference of the saving in `times` from 60 %, in percentage points.
NamedCells saving_cells(const NamedCells& times);

/// Number of different names among `names`.
std::int64_t different_names(const std::vector<std::string>& names);

}  // namespace endmill
