// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "support/named_cells.h"

namespace endmill {

/// The times and the length that Park and Maeng print, lists in the order aluminium, steel.
/// Source: [ParkMaeng, section 5].
struct PrintedTimes {
    std::vector<std::string> materials;
    double length_mm;                       ///< of the CL path
    std::vector<double> feeds_mm_per_min;   ///< constant, by hand
    std::vector<double> constant_feed_min;  ///< totals at these
    std::vector<double> variable_feed_min;  ///< totals with the feed varied
    double rounding_min;                    ///< by which printed times may be off
};

/// The columns of a table of times, their accounts and plans: row, those that `add_accounts`
/// tells, and those of `limit_cells` and `limit_claims`.
std::vector<std::string> time_columns();

/// Adds what follows from the printed numbers alone: length and non-cutting time by the two
/// constant feeds, non-cutting time by each and the length, totals at these feeds with
/// `noncut_min`, savings and cutting times; with the range that the rounding of the times leaves.
/// Source: docs/mathematics/ball-end-milling.md, section 8.
/// Fills the columns length_mm to greatest of `time_columns`.
void add_accounts(CsvTable& table, const PrintedTimes& printed, double noncut_min);

}  // namespace endmill
