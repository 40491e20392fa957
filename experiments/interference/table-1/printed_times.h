// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "endmill/surface/surface_jet.h"
#include "support/experiment.h"

namespace endmill {

inline constexpr const char* seconds_100 = "seconds_100";  ///< column for 100 planes
inline constexpr const char* seconds_50 = "seconds_50";    ///< column for 50 planes

/// A time of table 1, a cell of published.csv.
struct PrintedTime {
    std::size_t method;  ///< 1, 2 or 3
    const char* column;  ///< seconds_100 or seconds_50
};

/// The range of the time in s: it is rounded to whole seconds.
Interval printed_range(const PrintedTime& time);

/// The range of the ratio of two printed times.
Interval printed_ratio(const PrintedTime& over, const PrintedTime& under);

/// Whether `value` lies in `range`, ends included.
bool contains(const Interval& range, double value);

/// "method 1" for 1.
std::string method_name(std::size_t method);

/// Adds the rows that begin with `print`: what follows from the printed times alone.
/// \param proportional the range of t(100 planes) / t(50 planes) that counts as
///     proportional to the number of planes.
void add_printed(CsvTable& result, const Interval& proportional);

}  // namespace endmill
