// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace endmill {

/// Bytes that hold the text of any number; the longest has 24 characters.
inline constexpr std::size_t longest_number_text = 32;

/// Writes the text that `to_text` returns from `begin` on, without a string. Implemented in
/// `core/text.cpp`.
/// \param begin the first of `longest_number_text` bytes.
/// \return the end of the text.
/// \pre `value` is finite.
char* write_number(char* begin, double value);

}  // namespace endmill
