// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace endmill {

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
