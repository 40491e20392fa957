// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/text_scanner.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "endmill/core/text.h"

namespace endmill {
namespace {

// Longer than the lines of any writer. A file with longer lines is not a text.
constexpr std::size_t longest_line = std::size_t{1} << 20U;
constexpr std::size_t longest_echo = 40;
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

// The first `byte` in [begin, end), or `end`.
const char* find_byte(const char* begin, const char* end, char byte)
{
    const auto size = static_cast<std::size_t>(end - begin);
    const void* found = size > 0 ? std::memchr(begin, byte, size) : nullptr;
    return found != nullptr ? static_cast<const char*>(found) : end;
}

}  // namespace

TextScanner::TextScanner(std::string_view text, Kind kind)
    : text_{text},
      kind_{std::move(kind)},
      next_line_{text.data()},
      at_{text.data()},
      line_end_{text.data()}
{
    if (text.starts_with(byte_order_mark))
        next_line_ += byte_order_mark.size();
}

bool TextScanner::next_line()
{
    const char* const text_end = text_.data() + text_.size();
    while (next_line_ != text_end) {
        take_line();
        if (!at_line_end())
            return true;
    }
    skip_line();
    at_file_end_ = true;
    return false;
}

// Makes the next line the current one. The comment, if any, is cut off.
void TextScanner::take_line()
{
    const char* const text_end = text_.data() + text_.size();
    ++line_;
    at_ = next_line_;
    line_end_ = find_byte(at_, text_end, '\n');
    next_line_ = line_end_ == text_end ? text_end : line_end_ + 1;
    if (static_cast<std::size_t>(line_end_ - at_) > longest_line)
        throw FormatError{"E_LIMIT",
                          {kind_.file, std::to_string(line_), "line is longer than 1 MiB",
                           "lines of at most 1048576 bytes"}};
    if (kind_.comment != '\0')
        line_end_ = find_byte(at_, line_end_, kind_.comment);
}

std::string_view TextScanner::word_across_lines()
{
    if (at_line_end() && !next_line())
        return {};
    return word();
}

// Handles a word that std::from_chars refused: a number with a leading +, which other
// programs write, or an error.
double TextScanner::unusual_number()
{
    const std::string_view spelled = word();
    std::string_view digits = spelled;
    if (digits.starts_with('+') && !digits.starts_with("+-"))
        digits.remove_prefix(1);
    double value = 0;
    const char* const digits_end = digits.data() + digits.size();
    const auto [end, error] = std::from_chars(digits.data(), digits_end, value);
    if (error == std::errc::result_out_of_range && end == digits_end)
        throw FormatError{"E_RANGE",
                          {kind_.file, std::to_string(line_),
                           '"' + printable(spelled, longest_echo) + '"',
                           "a number that a double can hold"}};
    if (error != std::errc{} || end != digits_end)
        throw complaint_about(spelled, spelled.find(',') == std::string_view::npos
                                           ? "a number"
                                           : "a number, with \".\" as decimal sign");
    return value;
}

// A word of digits only is a whole number that exceeds 64 bits; other words are none.
void TextScanner::refuse_whole_number()
{
    const std::string_view spelled = word();
    const bool is_whole =
        !spelled.empty() &&
        spelled.substr(spelled.starts_with('-') ? 1 : 0)
                .find_first_not_of("0123456789") == std::string_view::npos &&
        spelled != "-";
    if (is_whole)
        throw FormatError{"E_RANGE",
                          {kind_.file, std::to_string(line_),
                           '"' + printable(spelled, longest_echo) + '"',
                           "a whole number of at most 64 bits"}};
    throw complaint_about(spelled, "a whole number");
}

void TextScanner::expect_line_end()
{
    if (!at_line_end())
        throw complaint_about(word(), "the end of the line");
}

FormatError TextScanner::complaint(const std::string& found,
                                   const std::string& expected) const
{
    return FormatError{kind_.syntax_code,
                       {kind_.file, std::to_string(line_), found, expected}};
}

// An empty word stands for the end of the line, or of the file if that is reached.
FormatError TextScanner::complaint_about(std::string_view word,
                                         const std::string& expected) const
{
    if (word.empty())
        return complaint(at_file_end_ ? "end of file" : "end of line", expected);
    return complaint('"' + printable(word, longest_echo) + '"', expected);
}

}  // namespace endmill
