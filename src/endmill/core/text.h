// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
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

/// `text` from a file or a command line, made fit for one line on a terminal: without
/// control characters (C0, DEL, C1), line separators and marks that turn the direction
/// of writing; each byte that is not UTF-8 becomes '?'.
/// \param max_characters if more remain, the first so many and "…".
std::string printable(std::string_view text, std::size_t max_characters =
                                                 std::numeric_limits<std::size_t>::max());

/// The one of `words` that `word` was probably meant to be: least edit distance
/// (insertions, deletions, replacements and swaps of neighbours), at most a third of the
/// length of `word` and at least 1. The first of several.
std::optional<std::string_view> closest_word(std::string_view word,
                                             std::span<const std::string_view> words);

/// The end of a complaint about `word`: `"u", "v" or "both"; did you mean "both"?`,
/// without the question if nothing is close.
/// \pre `words` is not empty.
std::string one_of(std::span<const std::string_view> words, std::string_view word);

}  // namespace endmill
