// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "endmill/core/error.h"

namespace endmill {

/// Iterates over the lines of a program and makes errors at the current line. A line ends
/// with LF; CRs before it belong to the line. A byte order mark at the beginning is
/// skipped.
class TextLines {
public:
    /// Name of a text and code of its errors.
    struct Kind {
        std::string file;  ///< name of the file for messages
        std::string code;  ///< code of its FormatErrors, such as "E_GCODE"
    };

    /// Stands before the first line.
    /// \param text must outlive this object.
    /// \param kind name and code for errors.
    /// \throws FormatError E_EMPTY if the text contains only white space.
    TextLines(std::string_view text, Kind kind);

    /// Goes to the next line. \return false if there is none.
    /// \throws FormatError E_LIMIT if the line is longer than 1 MiB; with the code of the
    ///         text if it has a CR that is not at its end, because some programs take it
    ///         for the end of a line.
    bool next();

    std::string_view line() const { return line_; }  ///< current line without its LF
    std::size_t number() const { return number_; }   ///< its number, from 1
    std::string_view rest() const { return rest_; }  ///< text after the current line
    const std::string& file() const { return kind_.file; }  ///< file name for messages

    /// An error at the current line.
    FormatError complaint(const std::string& found, const std::string& expected) const;

    /// An error E_RANGE at the current line, for a number that is too large or too small.
    FormatError range_complaint(const std::string& found,
                                const std::string& expected) const;

private:
    void refuse_lone_return() const;

    std::string_view rest_;
    Kind kind_;
    bool has_returns_ = false;  // whether the text has a CR
    std::string_view line_;
    std::size_t number_ = 0;
};

/// Checks a coordinate.
/// \throws FormatError E_RANGE at the current line of `lines` if |coordinate| exceeds
///         `max_extent_mm` or is not a number.
void check_extent(double coordinate_mm, double max_extent_mm, const TextLines& lines);

/// Whether `byte` is white space: a blank, tab, CR, LF, vertical tab or form feed.
inline bool is_blank(char byte)
{
    return byte == ' ' || ('\t' <= byte && byte <= '\r');
}

/// `text` without the white space at its beginning.
std::string_view without_indent(std::string_view text);

/// `text` in quotes, for one line on a terminal: at most 40 bytes of it, without white
/// space at the end. A character that a terminal may not show is written by its number:
/// "\u00a0" for a no-break space, "\x07" for a control character or a byte that is not
/// UTF-8.
std::string quoted(std::string_view text);

/// `value` with six significant digits, or "infinite", or "not a number", for messages.
std::string brief(double value);

}  // namespace endmill
