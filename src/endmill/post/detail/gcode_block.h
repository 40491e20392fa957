// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "endmill/post/detail/text_lines.h"

namespace endmill {

/// The codes of one letter in a block, in order; so many that two must be of one modal
/// group if there are more.
class GcodeCodes {
public:
    static constexpr std::size_t most = 20;  ///< more than there are groups

    bool is_full() const { return count_ == most; }  ///< whether `add` may not be called
    void add(int code) { codes_[count_++] = code; }  ///< \pre !is_full()
    std::span<const int> all() const { return {codes_.data(), count_}; }  ///< in order
    bool contains(int code) const;  ///< whether `add` was called with it

private:
    std::array<int, most> codes_ = {};
    std::size_t count_ = 0;
};

/// The words of one line of a program.
class GcodeBlock {
public:
    GcodeCodes g;  ///< G codes in tenths: 432 is G43.2
    GcodeCodes m;  ///< M codes, 0 to 999

    /// Whether there is a word `letter`, a capital.
    bool has(char letter) const { return ((present_ >> index(letter)) & 1U) != 0; }

    bool has_any(std::string_view letters) const;    ///< whether there is one of them
    bool is_empty() const { return present_ == 0; }  ///< whether there is no word

    /// The number of the word `letter`, neither G nor M. \pre has(letter)
    double value(char letter) const { return values_[index(letter)]; }

    /// Enters a word. \pre `letter` is a capital.
    void set(char letter, double value)
    {
        present_ |= 1U << index(letter);
        values_[index(letter)] = value;
    }

private:
    static std::size_t index(char letter)
    {
        return static_cast<std::size_t>(letter - 'A');
    }

    std::uint32_t present_ = 0;  // a bit a letter
    std::array<double, 26> values_ = {};
};

/// The words of `text`, which is the line where `lines` stands without what its reader
/// has looked at: letters with plain decimals, in any case, blanks anywhere, comments in
/// parentheses and from `;`.
/// Source: [KramerProctorMessina, "Format of a Line"].
/// \throws FormatError with the line for anything else: parameters, expressions and
///         O-words, a letter without a number or unknown, an exponent, a decimal comma, an
///         unclosed comment, a word twice; E_RANGE for a number that a double cannot hold.
GcodeBlock parse_block(std::string_view text, const TextLines& lines);

}  // namespace endmill
