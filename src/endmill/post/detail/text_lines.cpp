// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/text_lines.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>

namespace endmill {
namespace {

constexpr std::size_t longest_line = std::size_t{1} << 20U;  // bytes
constexpr std::size_t longest_echo = 40;  // bytes of a text that a message repeats
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

std::uint32_t byte_at(std::string_view text, std::size_t index)
{
    return static_cast<unsigned char>(text[index]);
}

// Number of bytes of the character outside ASCII at the beginning of `text`, or 0 if the
// bytes are not one in UTF-8.
std::size_t utf8_length(std::string_view text)
{
    const std::uint32_t first = byte_at(text, 0);
    std::size_t length = 0;
    if (0xC2U <= first && first <= 0xDFU)
        length = 2;
    else if (0xE0U <= first && first <= 0xEFU)
        length = 3;
    else if (0xF0U <= first && first <= 0xF4U)
        length = 4;
    if (length > text.size())
        return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte_at(text, i) & 0xC0U) != 0x80U)
            return 0;
    return length;
}

// The code point of a character of 2 to 4 bytes.
std::uint32_t code_point(std::string_view character)
{
    // The first byte has as many leading ones as there are bytes, and a zero.
    std::uint32_t code = byte_at(character, 0) & (0x7FU >> character.size());
    for (std::size_t i = 1; i < character.size(); ++i)
        code = (code << 6U) | (byte_at(character, i) & 0x3FU);
    return code;
}

void append_hexadecimal(std::string& text, std::uint32_t value, unsigned digits)
{
    constexpr unsigned bits_per_digit = 4;
    while (digits-- > 0)
        text += "0123456789abcdef"[(value >> (bits_per_digit * digits)) & 0xFU];
}

// Appends an ASCII character that prints as it is, and others by their number.
void append_character(std::string& shown, std::string_view character)
{
    constexpr std::uint32_t largest_short = 0xFFFF;
    if (character.size() == 1) {
        const char byte = character.front();
        if (' ' <= byte && byte <= '~') {
            shown += byte;
            return;
        }
        shown += "\\x";
        return append_hexadecimal(shown, byte_at(character, 0), 2);
    }
    const std::uint32_t code = code_point(character);
    shown += code <= largest_short ? "\\u" : "\\U";
    append_hexadecimal(shown, code, code <= largest_short ? 4 : 8);
}

}  // namespace

TextLines::TextLines(std::string_view text, Kind kind)
    : rest_{text},
      kind_{std::move(kind)}
{
    if (rest_.starts_with(byte_order_mark))
        rest_.remove_prefix(byte_order_mark.size());
    if (without_indent(rest_).empty())
        throw FormatError{"E_EMPTY",
                          {kind_.file, "", "file is empty", "a file with content"}};
    has_returns_ = rest_.find('\r') != std::string_view::npos;
}

bool TextLines::next()
{
    if (rest_.empty())
        return false;
    ++number_;
    const std::size_t length = std::min(rest_.find('\n'), rest_.size());
    if (length > longest_line)
        throw FormatError{
            "E_LIMIT",
            {kind_.file, std::to_string(number_), "line is longer than 1 MiB",
             "lines of at most 1048576 bytes"}};
    line_ = rest_.substr(0, length);
    rest_.remove_prefix(std::min(length + 1, rest_.size()));
    if (has_returns_)
        refuse_lone_return();
    return true;
}

void TextLines::refuse_lone_return() const
{
    const std::size_t end = line_.find('\r');
    if (end != std::string_view::npos &&
        line_.find_first_not_of('\r', end) != std::string_view::npos)
        throw complaint("a carriage return without a line feed",
                        "lines that end with LF or CRLF");
}

FormatError TextLines::complaint(const std::string& found,
                                 const std::string& expected) const
{
    return FormatError{kind_.code,
                       {kind_.file, std::to_string(number_), found, expected}};
}

FormatError TextLines::range_complaint(const std::string& found,
                                       const std::string& expected) const
{
    return FormatError{"E_RANGE", {kind_.file, std::to_string(number_), found, expected}};
}

void check_extent(double coordinate_mm, double max_extent_mm, const TextLines& lines)
{
    if (!(std::abs(coordinate_mm) <= max_extent_mm))
        throw lines.range_complaint(
            "coordinate " + brief(coordinate_mm) + " mm",
            "at most " + brief(max_extent_mm) + " mm (--max-extent)");
}

// White space is that of std::isspace in the "C" locale, without the cost of a locale.
std::string_view without_indent(std::string_view text)
{
    const auto begin = std::ranges::find_if_not(text, is_blank);
    text.remove_prefix(static_cast<std::size_t>(begin - text.begin()));
    return text;
}

std::string quoted(std::string_view text)
{
    while (!text.empty() && is_blank(text.back()))
        text.remove_suffix(1);
    std::string shown = "\"";
    std::string_view rest = text.substr(0, longest_echo);
    while (!rest.empty()) {
        const std::size_t length = std::max<std::size_t>(1, utf8_length(rest));
        append_character(shown, rest.substr(0, length));
        rest.remove_prefix(length);
    }
    shown += text.size() > longest_echo ? "...\"" : "\"";
    return shown;
}

std::string brief(double value)
{
    if (!std::isfinite(value))
        return std::isnan(value) ? "not a number" : "infinite";
    std::array<char, 32> buffer;  // sign, six digits, point and exponent take 13
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(),
                                            value, std::chars_format::general, 6);
    return {buffer.data(), end};
}

}  // namespace endmill
