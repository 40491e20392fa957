// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace endmill {

/// Shortest decimal text that reads back to the same double, with `.` as decimal sign.
/// \pre `value` is finite. Minus zero is written as "0".
std::string to_text(double value);

/// Appends what `to_text` gives, without a temporary.
void append_text(std::string& text, double value);

/// The double that the whole of `text` spells, in any locale.
/// \return nothing if `text` is not one decimal number, or if it overflows, underflows
/// to zero, or spells infinity or NaN.
std::optional<double> number_from_text(std::string_view text);

/// "1 point", "2 points".
std::string counted(std::size_t count, std::string_view thing);

}  // namespace endmill
