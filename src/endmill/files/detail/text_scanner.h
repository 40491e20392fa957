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

/// Walks over the lines of a text file and the words of each, keeping the place for
/// complaints. A line ends with LF; CR and other white space separate words like blanks.
/// A byte order mark at the beginning is skipped.
class TextScanner {
public:
    /// What a text is called, and how it is written.
    struct Kind {
        std::string file;         ///< its name for messages
        std::string syntax_code;  ///< of its FormatErrors, such as "E_STL_SYNTAX"
        char comment = '\0';  ///< begins a comment up to the end of the line, if not 0
    };

    /// \param text outlives the scanner, which stands before its first line.
    TextScanner(std::string_view text, Kind kind);

    /// Goes to the next line that holds a word.
    /// \return false if there is none; the scanner then stands at the end of the file.
    /// \throws FormatError E_LIMIT if a line is longer than 1 MiB.
    bool next_line();

    /// The line where the scanner stands, from 1; 0 before the first.
    std::size_t line() const { return line_; }

    /// Bytes of the text up to the end of the line where the scanner stands.
    std::size_t bytes_up_to_line_end() const
    {
        return static_cast<std::size_t>(next_line_ - text_.data());
    }

    /// Bytes of this line that are still to be read, a comment not counted.
    std::size_t bytes_left_in_line() const
    {
        return static_cast<std::size_t>(line_end_ - at_);
    }

    /// Whether no word is left in this line.
    bool at_line_end()
    {
        skip_blanks();
        return at_ == line_end_;
    }

    /// Leaves the rest of this line unread.
    void skip_line() { at_ = line_end_; }

    /// The next word of this line; empty if there is none.
    std::string_view word()
    {
        skip_blanks();
        const char* const begin = at_;
        while (at_ != line_end_ && !is_blank(*at_))
            ++at_;
        return {begin, static_cast<std::size_t>(at_ - begin)};
    }

    /// The next word of the file, in this line or a later one; empty at the end.
    std::string_view word_across_lines();

    /// The next word of this line, a number: possibly infinite or NaN, if it says so.
    /// \throws FormatError with the syntax code if it is none; E_RANGE if a double cannot
    /// hold it.
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

    /// The next word of this line, a whole number.
    /// \throws FormatError with the syntax code if it is none; E_RANGE if it needs more
    /// than 64 bits.
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

    /// \throws FormatError with the syntax code unless all words of this line are read.
    void expect_line_end();

    /// An error at this line, with the syntax code.
    FormatError complaint(const std::string& found, const std::string& expected) const;

    /// The same about `word`, quoted; empty stands for the end of the line or file.
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
    const char* next_line_;  // one past the line's LF
    const char* at_;
    const char* line_end_;
    std::size_t line_ = 0;
    bool at_file_end_ = false;
};

}  // namespace endmill
