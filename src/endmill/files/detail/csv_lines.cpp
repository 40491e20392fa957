// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/csv_lines.h"

#include <algorithm>
#include <utility>

// Large tables are read without copying: a cell is a view into the text. That is possible
// because cells with numbers and words never contain quotes or line ends; other cells are
// refused. Tables with free texts are read by `parse_csv`.

namespace endmill {
namespace {

// Large enough that a run outweighs the cost of starting it, small enough to balance
// threads.
constexpr std::size_t run_bytes = 1U << 18;

}  // namespace

// Counts line feeds. Lines of quoted cells with line feeds would be counted too often,
// but such cells are refused by CsvLines.
std::size_t line_count(std::string_view text)
{
    const auto ends = static_cast<std::size_t>(std::ranges::count(text, '\n'));
    return ends + (text.empty() || text.ends_with('\n') ? 0 : 1);
}

// Each run ends at the first line feed after `run_bytes` bytes; the division depends on
// the text only.
std::vector<CsvRun> csv_runs(std::string_view text)
{
    std::vector<CsvRun> runs;
    for (std::size_t line = 0; !text.empty(); line += line_count(runs.back().text)) {
        const std::size_t end = text.find('\n', std::min(run_bytes, text.size()));
        runs.push_back({text.substr(0, std::min(end, text.size() - 1) + 1), line});
        text.remove_prefix(runs.back().text.size());
    }
    return runs;
}

CsvLines::CsvLines(std::string_view text, std::string file, std::size_t lines_before)
    : rest_{text},
      file_{std::move(file)},
      line_{lines_before}
{
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (lines_before == 0 && rest_.starts_with(byte_order_mark))
        rest_.remove_prefix(byte_order_mark.size());
}

// An empty line has one empty cell, so a blank line in a table is reported as a row with
// too few cells.
bool CsvLines::next()
{
    if (rest_.empty())
        return false;
    ++line_;
    std::string_view line = rest_.substr(0, rest_.find('\n'));
    rest_.remove_prefix(std::min(line.size() + 1, rest_.size()));
    if (line.ends_with('\r'))
        line.remove_suffix(1);
    if (line.find('\r') != std::string_view::npos)
        throw complaint("E_CSV", "a carriage return without a line feed",
                        "lines that end with LF or CRLF");
    cells_.clear();
    if (line.find('"') == std::string_view::npos)
        split(line);
    else
        split_quoted(line);
    return true;
}

FormatError CsvLines::complaint(const std::string& code, const std::string& found,
                                const std::string& expected) const
{
    return FormatError{
        code, {file_, std::to_string(std::max<std::size_t>(line_, 1)), found, expected}};
}

// Splits a line without quotes at its commas.
void CsvLines::split(std::string_view line)
{
    for (;;) {
        const std::size_t comma = std::min(line.find(','), line.size());
        cells_.push_back(line.substr(0, comma));
        if (comma == line.size())
            return;
        line.remove_prefix(comma + 1);
    }
}

// Splits a line with at least one quoted cell. A doubled quote, by which RFC 4180
// represents a quote in a text, is refused as text after the end of a cell.
void CsvLines::split_quoted(std::string_view line)
{
    std::size_t at = 0;
    for (;;) {
        const bool is_quoted = at < line.size() && line[at] == '"';
        const std::size_t begin = is_quoted ? at + 1 : at;
        const std::size_t found = line.find(is_quoted ? '"' : ',', begin);
        if (is_quoted && found == std::string_view::npos)
            throw complaint("E_CSV", "a quote that is not closed", "a closing quote");
        const std::size_t end = std::min(found, line.size());
        const std::string_view cell = line.substr(begin, end - begin);
        at = is_quoted ? end + 1 : end;
        if (cell.find('"') != std::string_view::npos ||
            (at < line.size() && line[at] != ','))
            throw complaint("E_CSV", "a quote inside a cell or text after one",
                            "a comma or the end of the line");
        cells_.push_back(cell);
        if (at == line.size())
            return;
        ++at;
    }
}

}  // namespace endmill
