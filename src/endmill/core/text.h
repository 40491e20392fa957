// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace endmill {

/// \file
/// Numbers to and from text, and text for messages.

/// The shortest decimal text that reads back to the same double, with a point as decimal
/// sign.
/// \pre `value` is finite. Minus zero is written as "0".
std::string to_text(double value);

/// Appends `to_text(value)` to `text` without a temporary string.
void append_text(std::string& text, double value);

/// The double that `text` represents. The locale does not matter.
/// \return nothing if the whole of `text` is not one decimal number, if the number
///         overflows or underflows to zero, or if it is infinity or NaN.
std::optional<double> number_from_text(std::string_view text);

/// A count with its noun: "1 point", "2 points".
std::string counted(std::size_t count, std::string_view thing);

/// Makes text from a file or a command line safe to print on one line of a terminal.
/// Control characters (C0, DEL, C1), line separators and marks that change the writing
/// direction are removed. Each byte that is not valid UTF-8 becomes '?'.
/// \param text           may hold any bytes.
/// \param max_characters longer results are cut to this number of characters and end in
///         "…".
std::string printable(std::string_view text, std::size_t max_characters =
                                                 std::numeric_limits<std::size_t>::max());

/// The word that a person probably meant by `word`. It is the one of `words` with the
/// least edit distance (insertions, deletions, replacements and swaps of neighbouring
/// letters).
/// \return the first of several equally close words; nothing if the distance exceeds both
///         1 and a third of the length of `word`, or reaches half of the length without a
///         unit that both end in, or if `word` has more than 64 characters.
std::optional<std::string_view> closest_word(std::string_view word,
                                             std::span<const std::string_view> words);

/// The end of a message about a wrong `word`, such as `"u", "v" or "both"; did you mean
/// "both"?`. The question is left out if no word is close.
/// \pre `words` is not empty.
std::string one_of(std::span<const std::string_view> words, std::string_view word);

}  // namespace endmill
