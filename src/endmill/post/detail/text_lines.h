// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "endmill/core/error.h"

namespace endmill {

/// Walks over the lines of a program, keeping the place for complaints. A line ends with
/// LF; the CR before it belongs to it. A byte order mark at the beginning is skipped.
class TextLines {
public:
    /// What a text is called, and how complaints about it are.
    struct Kind {
        std::string file;  ///< its name for messages
        std::string code;  ///< of its FormatErrors, such as "E_GCODE"
    };

    /// \param text outlives this, which stands before its first line.
    /// \throws FormatError E_EMPTY if the text holds nothing but white space.
    TextLines(std::string_view text, Kind kind);

    /// Goes to the next line. \return false if there is none.
    /// \throws FormatError E_LIMIT if it is longer than 1 MiB.
    bool next();

    std::string_view line() const { return line_; }         ///< without its LF
    std::size_t number() const { return number_; }          ///< of this line, from 1
    std::string_view rest() const { return rest_; }         ///< what follows this line
    const std::string& file() const { return kind_.file; }  ///< the name for messages

    /// An error at this line.
    FormatError complaint(const std::string& found, const std::string& expected) const;

    /// An error E_RANGE at this line: a number that is too large or too small.
    FormatError range_complaint(const std::string& found,
                                const std::string& expected) const;

private:
    std::string_view rest_;
    Kind kind_;
    std::string_view line_;
    std::size_t number_ = 0;
};

inline bool is_blank(char byte)  ///< whether it is a blank, a tab, a CR or the like
{
    return byte == ' ' || ('\t' <= byte && byte <= '\r');
}

/// `text` without the blanks at its beginning.
std::string_view without_indent(std::string_view text);

/// `text` of a file in quotes, fit for one line on a terminal: up to 40 bytes, with '?'
/// for each that is no printing ASCII character.
std::string quoted(std::string_view text);

/// `value` with six significant digits, for messages; "infinite" or "not a number" if so.
std::string brief(double value);

}  // namespace endmill
