// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/text_lines.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace endmill {
namespace {

constexpr std::size_t longest_line = std::size_t{1} << 20U;  // bytes
constexpr std::size_t longest_echo = 40;  // bytes of a text that a message repeats
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

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
    return true;
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
    std::string shown = "\"";
    for (const char byte : text.substr(0, longest_echo))
        shown += ' ' <= byte && byte <= '~' ? byte : '?';
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
