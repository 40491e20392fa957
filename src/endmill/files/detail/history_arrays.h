// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "endmill/files/read_file.h"
#include "endmill/stock/stock_history.h"

/// \file
/// The history of a stock (its block and the earlier runs of cutters) as arrays of a VTK
/// XML file: the XML elements that refer to the arrays, and the arrays themselves.

namespace endmill {

/// The size of a history.
struct HistoryCounts {
    std::int64_t runs;  ///< number of runs
    std::int64_t tips;  ///< number of tips of all runs together
};

/// The size of `history`.
HistoryCounts counts_of(const StockHistory& history);

/// The counts in the head of a stock's file; nothing if the head has no history. The
/// counts may be any numbers and must be checked by the caller.
std::optional<HistoryCounts> named_history(std::string_view head);

/// The XML elements of the field data: `block_mm`, six numbers; `run_cutters_mm`, radius
/// and corner radius of each run; `run_tips`, the number of tips of each run and 1 if the
/// cutter stands at the first, else 0; and `tips_mm`.
/// \param offset of the first array behind the XML, in bytes.
std::string history_elements(const HistoryCounts& counts, std::uint64_t offset);

/// Length in bytes of all arrays, each with its size in front. The result is a double
/// because counts from a file might overflow an integer.
double history_bytes(const HistoryCounts& counts);

/// Appends the arrays, each with its size in front.
void append_history(std::string& file, const StockHistory& history);

/// Parses the arrays in `content` from byte `at` on.
/// \param file name of the file for messages.
/// \pre `content` has `history_bytes` bytes from `at` on.
/// \throws FormatError E_VTI for sizes that contradict the counts, and for a run without
///         tips; E_NONFINITE and E_RANGE for invalid numbers.
StockHistory parse_history(std::string_view content, std::size_t at,
                           const HistoryCounts& counts, const std::string& file,
                           const ReadLimits& limits);

}  // namespace endmill
