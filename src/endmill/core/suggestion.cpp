// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/text.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <numeric>
#include <vector>

namespace endmill {
namespace {

// Longer words get no suggestion: the comparison takes time as the square of the length.
constexpr std::size_t longest_word = 64;

using Row = std::vector<std::size_t>;

// Least number of edits, no part of a word edited twice (optimal string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b)
{
    Row before_last(b.size() + 1);
    Row last(b.size() + 1);
    Row row(b.size() + 1);
    std::iota(last.begin(), last.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before_last[j - 2] + 1);
        }
        std::swap(before_last, last);
        std::swap(last, row);
    }
    return last.back();
}

std::string quoted(std::string_view word)
{
    return '"' + std::string{word} + '"';
}

}  // namespace

std::optional<std::string_view> closest_word(std::string_view word,
                                             std::span<const std::string_view> words)
{
    if (word.size() > longest_word)
        return std::nullopt;
    std::optional<std::string_view> closest;
    std::size_t limit = std::max<std::size_t>(1, word.size() / 3);
    for (const std::string_view candidate : words) {
        const std::size_t distance = edit_distance(word, candidate);
        if (distance < limit || (distance == limit && !closest)) {
            closest = candidate;
            limit = distance;
        }
    }
    return closest;
}

std::string one_of(std::span<const std::string_view> words, std::string_view word)
{
    assert(!words.empty());
    std::string text = quoted(words.front());
    for (std::size_t i = 1; i < words.size(); ++i)
        text += (i + 1 < words.size() ? ", " : " or ") + quoted(words[i]);
    if (const auto closest = closest_word(word, words))
        text += "; did you mean " + quoted(*closest) + "?";
    return text;
}

}  // namespace endmill
