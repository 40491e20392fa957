// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/core/error.h"

namespace endmill {

/// A run of consecutive whole lines of a text.
struct CsvRun {
    std::string_view text;   ///< the lines
    std::size_t first_line;  ///< line of the text where the run begins, from 0
};

/// Divides `text` into runs of lines that several threads can read. A run has about
/// 256 KiB; the division does not depend on the number of threads.
std::vector<CsvRun> csv_runs(std::string_view text);

/// The number of lines in `text`; the last one need not end with a line feed.
std::size_t line_count(std::string_view text);

/// Reads the lines of a CSV text and splits each into cells, without copying. A line ends
/// with LF or CRLF; a byte order mark at the beginning is skipped. A quoted cell ends in
/// its line and contains no quote, which is enough for numbers and words.
class CsvLines {
public:
    /// \param text         outlives this object.
    /// \param file         name of the file for messages.
    /// \param lines_before number of lines of the file before `text`.
    CsvLines(std::string_view text, std::string file, std::size_t lines_before = 0);

    /// Goes to the next line. \return false if there is none.
    /// \throws FormatError E_CSV for a quote that is not closed in its line or stands
    ///         inside a cell, and for a carriage return inside a line.
    bool next();

    /// The cells of the current line, as views into the text.
    const std::vector<std::string_view>& cells() const { return cells_; }
    std::size_t line() const { return line_; }  ///< number of the current line, from 1

    /// The text after the current line.
    std::string_view rest() const { return rest_; }

    /// An error at the current line. \param code such as "E_CSV".
    FormatError complaint(const std::string& code, const std::string& found,
                          const std::string& expected) const;

private:
    void split(std::string_view line);
    void split_quoted(std::string_view line);

    std::string_view rest_;
    std::string file_;
    std::vector<std::string_view> cells_;
    std::size_t line_ = 0;
};

}  // namespace endmill
