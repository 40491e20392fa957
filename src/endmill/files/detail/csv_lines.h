// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/core/error.h"

namespace endmill {

/// Whole lines of a text that follow each other.
struct CsvRun {
    std::string_view text;
    std::size_t first_line;  ///< from 0 in the text
};

/// `text` as runs of lines that can be read side by side: some 256 KiB each, whatever the
/// number of threads.
std::vector<CsvRun> csv_runs(std::string_view text);

/// The number of lines in `text`; the last need not end.
std::size_t line_count(std::string_view text);

/// Walks over the lines of a CSV text and cuts each into cells, without copying. A line
/// ends with LF or CRLF; a byte order mark at the beginning is skipped. A cell in quotes
/// ends in its line, and has no quote inside: numbers and words need neither.
class CsvLines {
public:
    /// \param text outlives this. \param file the name for messages.
    /// \param lines_before of the file, if `text` begins after them: it then has no mark.
    CsvLines(std::string_view text, std::string file, std::size_t lines_before = 0);

    /// Goes to the next line. \return false if there is none.
    /// \throws FormatError E_CSV for a quote that is not closed in its line, or stands
    ///         inside a cell; for a carriage return inside a line.
    bool next();

    /// Of the line, as they stand in the text.
    const std::vector<std::string_view>& cells() const { return cells_; }
    std::size_t line() const { return line_; }  ///< from 1

    /// What follows the line.
    std::string_view rest() const { return rest_; }

    /// An error at this line. \param code such as "E_CSV".
    FormatError complaint(const std::string& code, const std::string& found,
                          const std::string& expected) const;

private:
    void cut(std::string_view line);
    void cut_quoted(std::string_view line);

    std::string_view rest_;
    std::string file_;
    std::vector<std::string_view> cells_;
    std::size_t line_ = 0;
};

}  // namespace endmill
