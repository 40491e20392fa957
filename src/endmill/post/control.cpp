// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/control.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "endmill/core/detail/units.h"
#include "endmill/core/error.h"
#include "endmill/post/program.h"

// The data of a control become part of a program that moves a machine. So every text is
// made of plain words, and the blocks at the start may only set modes.

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

// `word` without zeros before its number: G01 is G1.
std::string without_leading_zeros(std::string_view word)
{
    std::string result{word};
    while (result.size() > 2 && result[1] == '0' && is_digit(result[2]))
        result.erase(1, 1);
    return result;
}

// Words that would move the tool, end the program, or contradict what follows.
bool is_unfit_at_start(std::string_view word)
{
    constexpr std::array unfit{
        "G0",  "G1",  "G2",  "G3",  "G4",  "G5",  "G10", "G16", "G18",   "G19", "G20",
        "G21", "G28", "G30", "G31", "G38", "G41", "G42", "G51", "G52",   "G53", "G68",
        "G70", "G71", "G73", "G74", "G76", "G81", "G82", "G83", "G84",   "G85", "G86",
        "G87", "G88", "G89", "G91", "G92", "G93", "G95", "G96", "G90.1", "M0",  "M1",
        "M2",  "M3",  "M4",  "M6",  "M30", "M60", "M98", "M99"};
    const bool is_mode = word.front() == 'G' || word.front() == 'M' ||
                         word.front() == 'P' || word.front() == 'Q';
    return !is_mode ||
           std::ranges::find(unfit, without_leading_zeros(word)) != unfit.end();
}

void require_words(const std::vector<std::string>& blocks)
{
    for (const std::string& block : blocks)
        require(is_words(block), "control: a block must be made of words such as G90");
}

void require_word(const std::optional<std::string>& word, char letter)
{
    require(!word || is_word(*word, letter),
            "control: tool_change and coolant need one M word, tool_length one G word");
}

}  // namespace

double millimetres_per(ProgramUnit unit)
{
    return unit == ProgramUnit::Inch ? mm_per_inch : 1;
}

bool is_words(std::string_view text)
{
    return all_pieces(text, is_any_word);
}

bool is_word(std::string_view text, char letter)
{
    return is_any_word(text) && text.front() == letter;
}

std::optional<std::string> unfit_start_word(std::string_view words)
{
    std::optional<std::string> unfit;
    all_pieces(words, [&](std::string_view word) {
        if (is_unfit_at_start(word))
            unfit = std::string{word};
        return !unfit;
    });
    return unfit;
}

void require_sound(const Control& control)
{
    require_words(control.start);
    require_words(control.end);
    for (const std::string& block : control.start)
        require(!unfit_start_word(block), "control: a start block must only set modes");
    for (const auto& word : {control.tool_change, control.flood, control.mist,
                             std::optional{control.coolant_off}})
        require_word(word, 'M');
    require_word(control.tool_length, 'G');
    for (const int decimals :
         {control.decimals_mm, control.decimals_inch, control.speed_decimals.value_or(0)})
        require(0 <= decimals && decimals <= most_decimals,
                "control: need 0 to 9 decimals");
    require(control.largest_line_number >= 1,
            "control: need a largest line number from 1");
    require(control.program_number.value_or(1) >= 1,
            "control: need a program number from 1");
}

}  // namespace endmill
