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

/// \file
/// Tables in CSV files: a table in memory, its text, and a reader for small tables. The
/// readers of large tables (tool paths, curves, directions) do not use this type; they
/// split lines in place.

namespace endmill {

/// A cell to be written: unknown (written as an empty cell), a number, a whole number, or
/// a text.
using CsvCell = std::variant<std::monostate, double, std::int64_t, std::string>;

/// A table with named columns. Cells are stored as texts; a number is stored as the
/// shortest text that reads back to the same double.
class CsvTable {
public:
    /// An empty table.
    /// \param columns names of the columns, each with the unit of its numbers.
    /// \throws DomainError if there is no column, a name is empty, or two names are
    ///         equal.
    explicit CsvTable(std::vector<std::string> columns);

    /// Appends a row. A text that a spreadsheet would take for a formula (it begins with
    /// = + - @ or a tab) gets a leading apostrophe.
    /// \throws DomainError unless there is one cell for each column and every number is
    ///         finite.
    void add_row(std::span<const CsvCell> cells);
    void add_row(std::initializer_list<CsvCell> cells);  ///< the same for a list of cells

    std::span<const std::string> columns() const { return columns_; }  ///< in file order
    /// Number of rows, without the header.
    std::size_t rows() const { return lines_.size(); }

    /// The text of a cell; empty if its value is unknown. `row` counts from 0.
    /// \throws FormatError E_CSV if the table has no such column. \pre row < rows()
    const std::string& cell(std::size_t row, std::string_view column) const;

    /// The number in a cell; nothing if the cell is empty.
    /// \throws FormatError E_CSV if the cell holds another text. \pre row < rows()
    std::optional<double> number(std::size_t row, std::string_view column) const;

    /// The text of the CSV file: the header first, lines that end with '\n', cells quoted
    /// as in RFC 4180.
    std::string text() const;

private:
    friend CsvTable parse_csv(std::string_view text, const std::string& file);

    std::string file_;  // name for messages; empty if the table was not read from a file
    std::vector<std::string> columns_;
    std::vector<std::string> cells_;  // row by row
    std::vector<std::size_t> lines_;  // line of each row in the file, from 1
};

/// Reads a CSV text: cells separated by commas, quoted as in RFC 4180, lines that end
/// with LF or CRLF, with or without a byte order mark. The first line is the header.
/// \param file name of the file for messages.
/// \throws FormatError E_CSV with the line for a row whose number of cells differs from
///         the header, a quote that is not closed or stands inside a cell, and a column
///         without a name or with the name of another column.
CsvTable parse_csv(std::string_view text, const std::string& file);

/// Reads the file and parses it as `parse_csv` does.
/// \throws FormatError, LimitError also as `read_file`.
CsvTable read_csv(const std::filesystem::path& path, const ReadLimits& limits = {});

}  // namespace endmill
