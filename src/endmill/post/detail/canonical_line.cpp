// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/canonical_line.h"

#include <algorithm>
#include <cstddef>

#include "endmill/post/detail/text_lines.h"

namespace endmill {
namespace {

bool is_digit(char byte)
{
    return '0' <= byte && byte <= '9';
}

bool is_in_name(char byte)
{
    return ('A' <= byte && byte <= 'Z') || byte == '_' || byte == '.' || is_digit(byte);
}

// Number of bytes at the beginning of `text` that satisfy `holds`.
template <class Predicate>
std::size_t run_length(std::string_view text, Predicate holds)
{
    return static_cast<std::size_t>(std::ranges::find_if_not(text, holds) - text.begin());
}

// `text` without the white space at its end.
std::string_view without_tail(std::string_view text)
{
    while (!text.empty() && is_blank(text.back()))
        text.remove_suffix(1);
    return text;
}

}  // namespace

std::optional<CanonicalLine> canonical_line(std::string_view line)
{
    line = without_tail(without_indent(line));
    const std::size_t digits = run_length(line, is_digit);
    line.remove_prefix(digits);
    line = without_indent(line);
    if (digits == 0 || !line.starts_with('N'))
        return std::nullopt;
    line.remove_prefix(1);
    // The block number, padded with blanks to six digits, or dots if the block has none.
    line.remove_prefix(
        run_length(line, [](char byte) { return is_digit(byte) || byte == '.'; }));
    line = without_indent(line);
    const std::size_t name = run_length(line, is_in_name);
    const bool is_call = name > 0 && line.size() > name + 1 && line[name] == '(';
    if (!is_call || line.back() != ')')
        return std::nullopt;
    return CanonicalLine{line.substr(0, name),
                         line.substr(name + 1, line.size() - name - 2)};
}

std::optional<std::string_view> take_argument(std::string_view& arguments)
{
    arguments = without_indent(arguments);
    if (arguments.empty())
        return std::nullopt;
    const std::size_t comma = std::min(arguments.find(','), arguments.size());
    const std::string_view argument = without_tail(arguments.substr(0, comma));
    arguments.remove_prefix(std::min(comma + 1, arguments.size()));
    return argument;
}

}  // namespace endmill
