// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/csv.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/read_file.h"

// A CSV file is split into cells by CsvReader and stored as texts. Numbers are converted
// only when they are asked for, because most readers need a few columns of a table. RFC
// 4180 decides what a valid file is: a cell may be quoted; a quote in a quoted cell is
// doubled; quoted cells may contain commas and line ends.
// Writing is the reverse. Cells that a spreadsheet would run as a formula are prefixed,
// since result files are often opened in one.

namespace endmill {
namespace {

constexpr std::size_t longest_echo = 40;

// Prefixes a text that a spreadsheet would evaluate as a formula with an apostrophe.
std::string without_formula(std::string text)
{
    if (!text.empty() &&
        std::string_view{"=+-@\t"}.find(text.front()) != std::string::npos)
        text.insert(text.begin(), '\'');
    return text;
}

// The text that a cell is stored as. Numbers get the shortest text that reads back to the
// same double.
std::string cell_text(const CsvCell& cell)
{
    if (const auto* number = std::get_if<double>(&cell)) {
        require(std::isfinite(*number), "CsvTable: a number must be finite");
        return to_text(*number);
    }
    if (const auto* count = std::get_if<std::int64_t>(&cell))
        return std::to_string(*count);
    if (const auto* text = std::get_if<std::string>(&cell))
        return without_formula(*text);
    return {};
}

// Appends a cell, quoted as in RFC 4180 if it contains a comma, a quote or a line end.
void append_quoted(std::string& csv, std::string_view cell)
{
    if (cell.find_first_of(",\"\r\n") == std::string_view::npos) {
        csv += cell;
        return;
    }
    csv += '"';
    for (const char character : cell)
        csv.append(character == '"' ? 2 : 1, character);
    csv += '"';
}

// Appends a row with its line end.
void append_line(std::string& csv, std::span<const std::string> cells)
{
    // A row of one empty cell is written as "", because an empty line is not a row.
    if (cells.size() == 1 && cells.front().empty())
        csv += "\"\"";
    for (std::size_t i = 0; i < cells.size(); ++i) {
        csv += i == 0 ? "" : ",";
        append_quoted(csv, cells[i]);
    }
    csv += '\n';
}

// Splits a CSV text into rows of cells.
class CsvReader {
public:
    // Skips a byte order mark, which spreadsheets write at the beginning.
    CsvReader(std::string_view text, const std::string& file) : text_{text}, file_{file}
    {
        constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
        if (text_.starts_with(byte_order_mark))
            text_.remove_prefix(byte_order_mark.size());
    }

    bool at_end() const { return text_.empty(); }
    std::size_t line() const { return line_; }

    // Reads one row up to and including its line end. The last row need not have one.
    std::vector<std::string> row()
    {
        std::vector<std::string> cells{cell()};
        while (accept(","))
            cells.push_back(cell());
        if (!accept("\r\n") && !accept("\n") && !at_end())
            throw complaint(text_.front() == '"'
                                ? "a quote inside a cell or text after one"
                                : "a carriage return without a line feed",
                            "a comma or the end of the line");
        ++line_;
        return cells;
    }

    // An error at the current line.
    FormatError complaint(const std::string& found, const std::string& expected) const
    {
        return FormatError{"E_CSV", {file_, std::to_string(line_), found, expected}};
    }

private:
    // Skips `word` if the rest of the text begins with it. \return whether it does.
    bool accept(std::string_view word)
    {
        const bool found = text_.starts_with(word);
        if (found)
            text_.remove_prefix(word.size());
        return found;
    }

    // Reads one cell and stops before the comma or line end after it.
    std::string cell()
    {
        if (accept("\""))
            return quoted_cell();
        const std::string_view cell = text_.substr(0, text_.find_first_of(",\"\r\n"));
        text_.remove_prefix(cell.size());
        return std::string{cell};
    }

    // The rest of a quoted cell after its opening quote. It may span several lines.
    std::string quoted_cell()
    {
        std::string cell;
        const std::size_t first_line = line_;
        do {
            const std::size_t end = text_.find('"');
            if (end == std::string_view::npos) {
                // The message states the line of the opening quote, where the file must
                // be corrected.
                line_ = first_line;
                throw complaint("a quote that is never closed", "a closing quote");
            }
            cell += text_.substr(0, end);
            line_ += std::count(text_.begin(), text_.begin() + end, '\n');
            text_.remove_prefix(end + 1);
            if (text_.starts_with('"'))  // a doubled quote is a quote in the cell
                cell += '"';
        } while (accept("\""));
        return cell;
    }

    std::string_view text_;
    const std::string& file_;
    std::size_t line_ = 1;
};

// The reason why `columns` cannot be a header; empty if they can.
std::string column_fault(const std::vector<std::string>& columns)
{
    for (auto column = columns.begin(); column != columns.end(); ++column) {
        if (column->empty())
            return "a column without a name";
        if (std::find(columns.begin(), column, *column) != column)
            return "two columns named \"" + printable(*column, longest_echo) + "\"";
    }
    return {};
}

}  // namespace

CsvTable::CsvTable(std::vector<std::string> columns) : columns_{std::move(columns)}
{
    require(!columns_.empty(), "CsvTable: need a column");
    if (const std::string fault = column_fault(columns_); !fault.empty())
        throw DomainError{"CsvTable: " + fault};
}

void CsvTable::add_row(std::span<const CsvCell> cells)
{
    require(cells.size() == columns_.size(), "CsvTable: need one cell for each column");
    std::vector<std::string> texts;
    std::ranges::transform(cells, std::back_inserter(texts), cell_text);
    std::ranges::move(texts, std::back_inserter(cells_));
    lines_.push_back(lines_.size() + 2);  // the header is line 1
}

void CsvTable::add_row(std::initializer_list<CsvCell> cells)
{
    add_row(std::span<const CsvCell>{cells.begin(), cells.size()});
}

// Columns are found by a linear search: tables read this way have a few dozen columns.
const std::string& CsvTable::cell(std::size_t row, std::string_view column) const
{
    assert(row < rows());
    const auto found = std::find(columns_.begin(), columns_.end(), column);
    if (found == columns_.end())
        throw FormatError{"E_CSV",
                          {file_, "1", "no column \"" + std::string{column} + "\"",
                           "a column of this name"}};
    return cells_[row * columns_.size() + (found - columns_.begin())];
}

std::optional<double> CsvTable::number(std::size_t row, std::string_view column) const
{
    const std::string& text = cell(row, column);
    if (text.empty())
        return std::nullopt;
    const auto number = number_from_text(text);
    if (!number)
        throw FormatError{
            "E_CSV",
            {file_, std::to_string(lines_[row]),
             std::string{column} + " is \"" + printable(text, longest_echo) + "\"",
             "a number"}};
    return number;
}

std::string CsvTable::text() const
{
    std::string csv;
    append_line(csv, columns_);
    for (std::size_t row = 0; row < rows(); ++row)
        append_line(csv,
                    std::span{cells_}.subspan(row * columns_.size(), columns_.size()));
    return csv;
}

// The header is checked first, because every later message names columns.
CsvTable parse_csv(std::string_view text, const std::string& file)
{
    CsvReader reader{text, file};
    std::vector<std::string> header = reader.row();
    if (const std::string fault = column_fault(header); !fault.empty())
        throw FormatError{"E_CSV",
                          {file, "1", fault, "a name of its own for each column"}};
    CsvTable table{std::move(header)};
    table.file_ = file;
    const std::size_t width = table.columns_.size();
    while (!reader.at_end()) {
        const std::size_t line = reader.line();
        std::vector<std::string> cells = reader.row();
        if (cells.size() != width)
            throw FormatError{"E_CSV",
                              {file, std::to_string(line),
                               "row has " + std::to_string(cells.size()) + " cells",
                               std::to_string(width)}};
        std::ranges::move(cells, std::back_inserter(table.cells_));
        table.lines_.push_back(line);
    }
    return table;
}

// The memory is estimated from the size of the file, before any cell is made.
CsvTable read_csv(const std::filesystem::path& path, const ReadLimits& limits)
{
    // Every cell becomes a std::string; an empty cell takes one byte in the file, its
    // comma.
    constexpr double most_bytes_per_byte = 3 * sizeof(std::string);
    const std::string text = read_file(path, limits);
    const std::string file = shown_path(path);
    require_memory(file, most_bytes_per_byte * static_cast<double>(text.size()), limits);
    return parse_csv(text, file);
}

}  // namespace endmill
