// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>

#include "endmill/core/error.h"

namespace endmill {

/// Reads a text file line by line and word by word, and knows the current line for error
/// messages. A line ends with LF; CR and other white space separate words, like blanks. A
/// byte order mark at the beginning is skipped. The functions for numbers are inline
/// because they dominate the time of reading a mesh.
class TextScanner {
public:
    /// The name of a text, and its syntax.
    struct Kind {
        std::string file;         ///< name of the file for messages
        std::string syntax_code;  ///< of its FormatErrors, such as "E_STL_SYNTAX"
        char comment = '\0';  ///< begins a comment to the end of the line; 0: no comments
    };

    /// Starts before the first line. \param text outlives the scanner.
    TextScanner(std::string_view text, Kind kind);

    /// Goes to the next line that has a word.
    /// \return false if there is none; the scanner is then at the end of the file.
    /// \throws FormatError E_LIMIT if a line is longer than 1 MiB.
    bool next_line();

    /// Number of the current line, from 1; 0 before the first.
    std::size_t line() const { return line_; }

    /// Number of bytes of the text up to the end of the current line.
    std::size_t bytes_up_to_line_end() const
    {
        return static_cast<std::size_t>(next_line_ - text_.data());
    }

    /// Number of unread bytes of the current line, without its comment.
    std::size_t bytes_left_in_line() const
    {
        return static_cast<std::size_t>(line_end_ - at_);
    }

    /// Whether the current line has no further word.
    bool at_line_end()
    {
        skip_blanks();
        return at_ == line_end_;
    }

    /// Skips the rest of the current line.
    void skip_line() { at_ = line_end_; }

    /// The next word of the current line; empty if there is none.
    std::string_view word()
    {
        skip_blanks();
        const char* const begin = at_;
        while (at_ != line_end_ && !is_blank(*at_))
            ++at_;
        return {begin, static_cast<std::size_t>(at_ - begin)};
    }

    /// The next word of the current line or of a later one; empty at the end of the file.
    std::string_view word_across_lines();

    /// The next word of the current line as a number; "inf" and "nan" are accepted.
    /// \throws FormatError with the syntax code if it is not a number; E_RANGE if it
    ///         overflows or underflows a double.
    double number()
    {
        skip_blanks();
        double value = 0;
        const auto [end, error] = std::from_chars(at_, line_end_, value);
        if (error != std::errc{} || !ends_word(end))
            return unusual_number();
        at_ = end;
        return value;
    }

    /// The next word of the current line as a whole number.
    /// \throws FormatError with the syntax code if it is not a whole number; E_RANGE if
    ///         it needs more than 64 bits.
    std::int64_t whole_number()
    {
        skip_blanks();
        std::int64_t value = 0;
        const auto [end, error] = std::from_chars(at_, line_end_, value);
        if (error != std::errc{} || !ends_word(end))
            refuse_whole_number();
        at_ = end;
        return value;
    }

    /// Checks that the current line has no further word.
    /// \throws FormatError with the syntax code if it has one.
    void expect_line_end();

    /// An error at the current line, with the syntax code.
    FormatError complaint(const std::string& found, const std::string& expected) const;

    /// The same for an unexpected `word`; an empty word means the end of the line or
    /// file.
    FormatError complaint_about(std::string_view word, const std::string& expected) const;

private:
    static bool is_blank(char byte)
    {
        return byte == ' ' || ('\t' <= byte && byte <= '\r');
    }
    bool ends_word(const char* at) const { return at == line_end_ || is_blank(*at); }
    void skip_blanks()
    {
        while (at_ != line_end_ && is_blank(*at_))
            ++at_;
    }
    void take_line();
    double unusual_number();
    [[noreturn]] void refuse_whole_number();

    std::string_view text_;
    Kind kind_;
    const char* next_line_;  // one past the LF of the current line
    const char* at_;
    const char* line_end_;
    std::size_t line_ = 0;
    bool at_file_end_ = false;
};

}  // namespace endmill
