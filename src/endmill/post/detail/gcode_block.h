// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "endmill/post/detail/text_lines.h"

namespace endmill {

/// The G codes that programs of three axes need, for messages. The reader knows a few more.
inline constexpr std::string_view known_g_codes =
    "a G code of three-axis milling: G0 to G4, G17 to G21, G28, G30, G40, G43, G49, G53 "
    "to "
    "G59, G61, G64, G73, G74, G80 to G86, G88 to G94, G96 to G99";

/// The codes of one letter (G or M) in a block, in order. The capacity exceeds the number
/// of modal groups, so a block with more codes is wrong in any case.
class GcodeCodes {
public:
    /// Capacity; more than there are modal groups.
    static constexpr std::size_t most = 20;

    bool is_full() const { return count_ == most; }  ///< whether no code can be added
    void add(int code) { codes_[count_++] = code; }  ///< \pre !is_full()
    std::span<const int> all() const { return {codes_.data(), count_}; }  ///< in order
    bool contains(int code) const;  ///< whether `code` is among them

private:
    std::array<int, most> codes_ = {};
    std::size_t count_ = 0;
};

/// The words of one line of a program.
class GcodeBlock {
public:
    GcodeCodes g;  ///< G codes in tenths: 432 is G43.2
    GcodeCodes m;  ///< M codes, 0 to 999

    /// Whether the block has a word with this letter. \pre `letter` is a capital.
    bool has(char letter) const { return ((present_ >> index(letter)) & 1U) != 0; }

    bool has_any(std::string_view letters) const;  ///< whether it has one of these words
    bool is_empty() const { return present_ == 0; }  ///< whether it has no word

    /// The number of the word `letter`, which is neither G nor M. \pre has(letter)
    double value(char letter) const { return values_[index(letter)]; }

    /// Adds a word. \pre `letter` is a capital.
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

    std::uint32_t present_ = 0;  // one bit per letter
    std::array<double, 26> values_ = {};
};

/// The words of a line: letters in any case with plain decimals, with blanks anywhere,
/// comments in parentheses and comments from `;`.
/// \param text the current line of `lines`, without a prefix that the caller has handled.
/// \param lines for error messages.
/// \throws FormatError with file and line for anything else: parameters, expressions,
///         O-words, an unknown letter or one without a number, an exponent, a decimal
///         comma, an unclosed comment, a repeated word; E_RANGE for a number that a
///         double cannot store.
/// Source: [KramerProctorMessina, section 3.3].
GcodeBlock parse_block(std::string_view text, const TextLines& lines);

}  // namespace endmill
