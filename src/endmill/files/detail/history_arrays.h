// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "endmill/files/read_file.h"
#include "endmill/stock/stock_history.h"

namespace endmill {

/// How much of a history there is.
struct HistoryCounts {
    std::int64_t runs;
    std::int64_t tips;  ///< of all runs
};

HistoryCounts counts_of(const StockHistory& history);

/// The counts that the head of a stock's file names, which may be any numbers; nothing if
/// it names no history.
std::optional<HistoryCounts> named_history(std::string_view head);

/// The elements of VTK's XML that refer to a history's arrays: field data `block_mm`, six
/// numbers; `run_cutters_mm`, radius and corner radius of each run; `run_tips`, how many
/// of the tips are each run's, and 1 if it stands at the first, else 0; and `tips_mm`.
/// \param offset of the first array behind the XML, in bytes.
std::string history_elements(const HistoryCounts& counts, std::uint64_t offset);

/// Length of the arrays in bytes, each behind its size. Counted in doubles, as counts that
/// were read are not to be trusted.
double history_bytes(const HistoryCounts& counts);

/// Appends the arrays, each behind its size.
void append_history(std::string& file, const StockHistory& history);

/// The history whose arrays stand in `content` from `at` on. \param file named in messages.
/// \pre `content` goes on for `history_bytes` at least.
/// \throws FormatError E_VTI for sizes that do not fit the counts, a run without a tip or
///         one that is none of ours; E_NONFINITE and E_RANGE for numbers out of range.
StockHistory parse_history(std::string_view content, std::size_t at,
                           const HistoryCounts& counts, const std::string& file,
                           const ReadLimits& limits);

}  // namespace endmill
