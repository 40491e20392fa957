// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "endmill/files/read_file.h"

namespace endmill {

/// A cell to be written: unknown, a number, a whole number, or a text.
using CsvCell = std::variant<std::monostate, double, std::int64_t, std::string>;

/// A table with named columns, as a CSV file holds it: cells are texts, numbers spelled
/// so that they read back to the same double.
class CsvTable {
public:
    /// \param columns names, with the unit of what stands below them.
    /// \throws DomainError unless there is one, and each is a name of its own.
    explicit CsvTable(std::vector<std::string> columns);

    /// Appends a row. A text that a spreadsheet would take for a formula (it begins with
    /// = + - @ or a tab) gets a leading apostrophe.
    /// \throws DomainError unless there is a cell a column and every number is finite.
    void add_row(std::span<const CsvCell> cells);
    void add_row(std::initializer_list<CsvCell> cells);  ///< the same

    std::span<const std::string> columns() const { return columns_; }  ///< in order
    std::size_t rows() const { return lines_.size(); }  ///< without the header

    /// The text of a cell, empty if unknown; `row` counts from 0.
    /// \throws FormatError if the table has no such column. \pre row < rows()
    const std::string& cell(std::size_t row, std::string_view column) const;

    /// The number in a cell; none if it is empty.
    /// \throws FormatError if it holds anything else. \pre row < rows()
    std::optional<double> number(std::size_t row, std::string_view column) const;

    /// The whole file: header first, lines end with '\n', quotes as RFC 4180 has them.
    std::string text() const;

private:
    friend CsvTable parse_csv(std::string_view text, const std::string& file);

    std::string file_;  // empty for a table that was not read
    std::vector<std::string> columns_;
    std::vector<std::string> cells_;  // row by row
    std::vector<std::size_t> lines_;  // of each row in the file
};

/// Reads a CSV text: commas, quotes as RFC 4180 has them, lines that end with LF or CRLF,
/// with or without a byte order mark, the first line the header.
/// \param file the name for messages.
/// \throws FormatError E_CSV with the line for a row with another number of cells than
/// the
///         header, a quote that is not closed or stands inside a cell, a column without a
///         name or with that of another.
CsvTable parse_csv(std::string_view text, const std::string& file);

/// The same from a file. \throws FormatError and LimitError also as `read_file`.
CsvTable read_csv(const std::filesystem::path& path, const ReadLimits& limits = {});

}  // namespace endmill
