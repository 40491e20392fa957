// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/gcode_block.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <system_error>

// The parser runs over the line once:
// 1. skip blanks, and comments in parentheses; stop at `;` or the end;
// 2. read a letter;
// 3. read a signed plain decimal. Blanks may stand between its digits, which is rare:
//    then the digits are collected and converted again without the blanks;
// 4. enter the word. G and M codes go to lists, other words must not repeat.
// Anything else is refused with a message that names the likely intention.

namespace endmill {
namespace {

constexpr std::string_view known_letters = "ABCDFGHIJKLMNPQRSTXYZ";
constexpr std::string_view expand_first =
    "plain numbers: --interpreter linuxcnc expands them";
constexpr std::string_view expand_subroutines =
    "moves alone: --interpreter linuxcnc expands subroutines";
constexpr double g_steps = 10;  // G codes are stored in tenths
constexpr double largest_g_code = 999;
constexpr double largest_m_code = 999;
// Number of letters of a line that are searched for the name of a tool-centre-point
// function.
constexpr std::size_t longest_call = 40;

bool is_digit_or_point(char byte)
{
    return ('0' <= byte && byte <= '9') || byte == '.';
}

char capital(char byte)
{
    return 'a' <= byte && byte <= 'z' ? static_cast<char>(byte - 'a' + 'A') : byte;
}

bool is_letter(char byte)
{
    return 'A' <= capital(byte) && capital(byte) <= 'Z';
}

// Whether a screen does not show the byte: a control character or a part of a character
// outside ASCII, such as a no-break space.
bool is_hidden(char byte)
{
    return !(' ' <= byte && byte <= '~');
}

class BlockParser {
public:
    BlockParser(std::string_view text, const TextLines& lines)
        : lines_{lines},
          begin_{text.data()},
          at_{begin_},
          end_{text.data() + text.size()}
    {
    }

    GcodeBlock parse()
    {
        for (skip_blanks(); at_ != end_ && *at_ != ';'; skip_blanks()) {
            if (*at_ == '(')
                skip_comment();
            else
                take_word();
        }
        return block_;
    }

private:
    void skip_blanks()
    {
        while (at_ != end_ && is_blank(*at_))
            ++at_;
    }

    std::string_view rest() const { return {at_, static_cast<std::size_t>(end_ - at_)}; }

    // The language forbids nested comments.
    void skip_comment()
    {
        const char* const close =
            std::find_if(at_ + 1, end_, [](char c) { return c == '(' || c == ')'; });
        if (close == end_)
            throw lines_.complaint("unclosed comment " + quoted(rest()), "a )");
        if (*close == '(')
            throw lines_.complaint("comment in a comment " + quoted(rest()),
                                   "a ) before the next (");
        at_ = close + 1;
    }

    void take_word()
    {
        const char letter = capital(*at_);
        if (known_letters.find(letter) == std::string_view::npos)
            refuse_character();
        ++at_;
        enter(letter, number(letter));
    }

    // The language allows blanks inside a number. They are rare, so the number is first
    // read without them and again only if more digits follow.
    double number(char letter)
    {
        skip_blanks();
        const bool is_negative = at_ != end_ && *at_ == '-';
        if (is_negative || (at_ != end_ && *at_ == '+')) {
            ++at_;
            skip_blanks();
        }
        if (at_ == end_ || !is_digit_or_point(*at_))
            refuse_number(letter);
        const char* const begin = at_;
        double magnitude = 0;
        const auto [after, error] =
            std::from_chars(at_, end_, magnitude, std::chars_format::fixed);
        at_ = after;
        skip_blanks();
        if (error != std::errc{} || (at_ != end_ && is_digit_or_point(*at_)))
            magnitude = scattered_number(letter, begin);
        return is_negative ? -magnitude : magnitude;
    }

    // Reads a number again with the blanks removed, or refuses it.
    double scattered_number(char letter, const char* begin)
    {
        std::string digits;
        for (at_ = begin; at_ != end_ && (is_blank(*at_) || is_digit_or_point(*at_));
             ++at_)
            if (!is_blank(*at_))
                digits += *at_;
        double magnitude = 0;
        const char* const digits_end = digits.data() + digits.size();
        const auto [after, error] = std::from_chars(digits.data(), digits_end, magnitude,
                                                    std::chars_format::fixed);
        if (error == std::errc::result_out_of_range && after == digits_end)
            throw lines_.range_complaint(quoted(letter + digits),
                                         "a number that a double can store");
        if (error != std::errc{} || after != digits_end)
            throw lines_.complaint(quoted(letter + digits), "a number with one point");
        return magnitude;
    }

    void enter(char letter, double value)
    {
        if (letter == 'G')
            return enter_code(letter, value, g_steps, largest_g_code);
        if (letter == 'M')
            return enter_code(letter, value, 1, largest_m_code);
        if (block_.has(letter))
            throw lines_.complaint(std::string{"word "} + letter + " twice in a block",
                                   "the word once");
        block_.set(letter, value);
    }

    // `steps` is the number of codes per unit: 10 for G codes, 1 for M codes.
    void enter_code(char letter, double value, double steps, double largest)
    {
        const double code = std::round(value * steps);
        // Parsing the decimal and dividing by 10 are both correctly rounded, so a valid
        // code gives the same double.
        if (!(code / steps == value && 0 <= value && value <= largest))
            throw lines_.complaint(
                "unknown code " + (letter + brief(value)),
                letter == 'G' ? std::string{known_g_codes} : "M0 to M999");
        GcodeCodes& codes = letter == 'G' ? block_.g : block_.m;
        if (codes.is_full() || codes.contains(static_cast<int>(code)))
            throw lines_.complaint(
                letter + brief(value) + " twice in a block, or with too many other codes",
                "one code of each modal group");
        codes.add(static_cast<int>(code));
        block_.set(letter, value);
    }

    // The character cannot begin a word; the message names what it probably is.
    [[noreturn]] void refuse_character() const
    {
        const char byte = capital(*at_);
        const std::string shown = quoted(rest());
        if (byte == '#')
            throw lines_.complaint("parameter " + shown, std::string{expand_first});
        if (byte == '[' || byte == ']')
            throw lines_.complaint("expression " + shown, std::string{expand_first});
        if (byte == 'O')
            throw lines_.complaint("O-word " + shown, std::string{expand_subroutines});
        const bool is_in_number = at_ != begin_ && is_digit_or_point(at_[-1]);
        if (byte == 'E' && is_in_number)
            throw lines_.complaint("exponent " + shown,
                                   "a plain decimal number without exponent");
        if (byte == ',' && is_in_number)
            throw lines_.complaint("decimal comma " + shown, "\".\" as decimal sign");
        if (byte == '@' || byte == '^')
            throw lines_.complaint("polar coordinates " + shown,
                                   "X and Y: --interpreter linuxcnc expands them");
        if (byte == ')')
            throw lines_.complaint(shown, "a ( before the )");
        if (is_letter(byte))
            throw lines_.complaint("unknown word " + shown,
                                   "words of " + std::string{known_letters});
        refuse_if_centre_point();
        if (is_hidden(byte))
            refuse_hidden(at_);
        throw lines_.complaint(shown, "a word: a letter and a number");
    }

    [[noreturn]] void refuse_hidden(const char* from) const
    {
        throw lines_.complaint("a hidden character in " +
                                   quoted({from, static_cast<std::size_t>(end_ - from)}),
                               "words of letters and numbers");
    }

    // The letter has been read, and no number follows.
    [[noreturn]] void refuse_number(char letter) const
    {
        refuse_if_centre_point();
        if (at_ != end_ && (*at_ == '#' || *at_ == '[' || *at_ == ']'))
            refuse_character();
        if (at_ != end_ && is_hidden(*at_))
            refuse_hidden(at_ - 1);
        throw lines_.complaint(quoted(std::string_view{&letter, 1}) + " without a number",
                               "a plain decimal number after the letter");
    }

    // Siemens and Heidenhain controls switch tool-centre-point control on by a name in a
    // line of its own: TRAORI, FUNCTION TCPM.
    void refuse_if_centre_point() const
    {
        std::string letters;
        for (const char* next = begin_; next != end_ && letters.size() < longest_call;
             ++next)
            if (is_letter(*next))
                letters += capital(*next);
        for (const std::string_view name : {"TRAORI", "TCPM"})
            if (letters.find(name) != std::string::npos)
                throw lines_.complaint("tool-centre-point code " + quoted(name),
                                       "positions of the axes, or tips with rotary "
                                       "words (--frame part)");
    }

    const TextLines& lines_;
    const char* begin_;
    const char* at_;
    const char* end_;
    GcodeBlock block_;
};

}  // namespace

bool GcodeCodes::contains(int code) const
{
    return std::ranges::find(all(), code) != all().end();
}

bool GcodeBlock::has_any(std::string_view letters) const
{
    return std::ranges::any_of(letters, [&](char letter) { return has(letter); });
}

GcodeBlock parse_block(std::string_view text, const TextLines& lines)
{
    return BlockParser{text, lines}.parse();
}

}  // namespace endmill
