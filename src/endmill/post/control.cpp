// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/control.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "endmill/core/error.h"

// The data of a control become part of a program that moves a machine. So every text is
// made of plain words, and the blocks at the start may only set modes. A list of allowed
// codes says which: a list of forbidden ones would miss those of other controls.

namespace endmill {
namespace {

bool is_digit(char character)
{
    return '0' <= character && character <= '9';
}

// Whether `text` is digits with at most one point between or after them.
bool is_unsigned_decimal(std::string_view text)
{
    return !text.empty() && is_digit(text.front()) &&
           std::ranges::count(text, '.') <= 1 &&
           std::ranges::all_of(text, [](char character) {
               return is_digit(character) || character == '.';
           });
}

bool is_any_word(std::string_view text)
{
    if (text.size() < 2 || text.front() < 'A' || text.front() > 'Z')
        return false;
    std::string_view number = text.substr(1);
    if (number.starts_with('-'))
        number.remove_prefix(1);
    return is_unsigned_decimal(number);
}

// Calls `use` for each piece of `text` between blanks until it returns false.
template <class Use>
bool all_pieces(std::string_view text, Use use)
{
    for (;;) {
        const std::size_t blank = text.find(' ');
        if (!use(text.substr(0, blank)))
            return false;
        if (blank == std::string_view::npos)
            return true;
        text.remove_prefix(blank + 1);
    }
}

// The number of a G or M word in tenths: 591 for G59.1. Nothing for other words, for a
// number with a sign or a bare point, and for more than one digit after the point.
std::optional<int> code_in_tenths(std::string_view word)
{
    constexpr std::size_t most_digits = 4;
    const std::string_view number = word.substr(1);
    const std::size_t point = std::min(number.find('.'), number.size());
    if (point == 0 || point > most_digits || number.size() == point + 1 ||
        number.size() > point + 2)
        return std::nullopt;
    int tenths = 0;
    for (const char character : number) {
        if (character == '.')
            continue;
        if (!is_digit(character))
            return std::nullopt;
        tenths = 10 * tenths + (character - '0');
    }
    return point == number.size() ? 10 * tenths : tenths;
}

template <std::size_t count>
bool holds(const std::array<int, count>& codes, std::optional<int> code)
{
    return code && std::ranges::find(codes, *code) != codes.end();
}

bool is_g_code_of(std::string_view word, const auto& codes)
{
    return word.front() == 'G' && holds(codes, code_in_tenths(word));
}

// Codes that only set modes, in tenths. G20, G21 and G61 or G64 of the writer itself need
// no place here.
constexpr std::array start_g_codes{51,  80,  150, 170, 400, 490, 500, 501, 540, 541, 550,
                                   560, 570, 580, 590, 591, 592, 593, 610, 611, 640, 670,
                                   690, 800, 900, 911, 940, 970, 980, 990, 1870};
constexpr std::array start_m_codes{480};
constexpr std::array g_codes_with_p_and_q{51, 541, 640, 1870};

// Words that could move the tool, turn the spindle, end the program, call another one, or
// contradict what follows, and all words that are unknown.
bool is_unfit_at_start(std::string_view word, bool takes_p_and_q)
{
    switch (word.front()) {
        case 'G':
            return !is_g_code_of(word, start_g_codes);
        case 'M':
            return !holds(start_m_codes, code_in_tenths(word));
        case 'P':
        case 'Q':
            return !takes_p_and_q || word[1] == '-';
        default:
            return true;
    }
}

void require_words(const std::vector<std::string>& blocks)
{
    for (const std::string& block : blocks)
        require(is_words(block), "control: a block must be made of words such as G90");
}

// Whether `number` is absent or between `low` and `high`.
template <class Number>
bool is_within(const std::optional<Number>& number, Number low, Number high)
{
    return !number || (low <= *number && *number <= high);
}

void require_numbers(const Control& control)
{
    for (const int decimals :
         {control.decimals_mm, control.decimals_inch, control.speed_decimals.value_or(0)})
        require(0 <= decimals && decimals <= most_decimals,
                "control: need 0 to 9 decimals");
    require(is_within(std::optional{control.largest_line_number}, 1, most_numbered_lines),
            "control: need a largest line number from 1 to 99999999");
    require(is_within(control.program_number, 1, largest_program_number),
            "control: need a program number from 1 to 99999999");
    require(is_within(control.longest_line, least_longest_line, most_longest_line),
            "control: need a longest line of 40 to 1000000 characters");
}

}  // namespace

bool is_words(std::string_view text)
{
    return all_pieces(text, is_any_word);
}

bool is_word(std::string_view text, char letter)
{
    return is_any_word(text) && text.front() == letter;
}

bool is_auxiliary_word(std::string_view text)
{
    constexpr std::array unfit{0,   10,  20,  30,  40,   50,  300,
                               600, 970, 980, 990, 1980, 1990};
    if (!is_word(text, 'M'))
        return false;
    const std::optional<int> code = code_in_tenths(text);
    return code && *code % 10 == 0 && !holds(unfit, code);
}

bool is_tool_length_word(std::string_view text)
{
    return is_word(text, 'G') && code_in_tenths(text) == 430;
}

bool ends_program(std::string_view words)
{
    constexpr std::array end_codes{20, 300};
    return !all_pieces(words, [&](std::string_view word) {
        return word.front() != 'M' || !holds(end_codes, code_in_tenths(word));
    });
}

std::optional<std::string> unfit_start_word(std::string_view words)
{
    bool takes_p_and_q = false;
    all_pieces(words, [&](std::string_view word) {
        takes_p_and_q = takes_p_and_q || is_g_code_of(word, g_codes_with_p_and_q);
        return true;
    });
    std::optional<std::string> unfit;
    all_pieces(words, [&](std::string_view word) {
        if (is_unfit_at_start(word, takes_p_and_q))
            unfit = std::string{word};
        return !unfit;
    });
    return unfit;
}

void require_sound(const Control& control)
{
    require_words(control.start);
    require_words(control.end);
    require(std::ranges::any_of(control.end, ends_program),
            "control: need M2 or M30 in a block at the end");
    for (const std::string& block : control.start)
        require(!unfit_start_word(block), "control: a start block must only set modes");
    for (const auto& word : {control.tool_change, control.flood, control.mist,
                             std::optional{control.coolant_off}})
        require(!word || is_auxiliary_word(*word),
                "control: tool_change and coolant need an M word that neither stops, "
                "ends, calls a program nor turns the spindle");
    require(!control.tool_length || is_tool_length_word(*control.tool_length),
            "control: the tool length needs G43");
    require_numbers(control);
}

}  // namespace endmill
