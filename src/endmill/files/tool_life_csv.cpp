// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/input_csv.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "endmill/core/text.h"
#include "endmill/files/detail/named_columns.h"
#include "endmill/files/read_file.h"

namespace endmill {
namespace {

constexpr std::array<std::string_view, 2> names{"phi_over_pi", "v_m_per_min"};
constexpr double most_speed = 1e6;  // m/min: beyond every speed; its powers are finite

// The number in a cell, from 0 (excluded) to `most`.
double number(const CsvLines& lines, const NamedColumns& columns, std::size_t column,
              double most)
{
    const auto number = number_from_text(columns.cell(lines, column));
    if (number && *number > 0 && *number <= most)
        return *number;
    throw columns.complaint(lines, column, "a number above 0, at most " + to_text(most));
}

// Checks that there are two different angles, which a line through the data needs.
void require_spread(const std::vector<CuttingSpeedDatum>& data, const CsvLines& lines)
{
    const auto is_other = [&](const CuttingSpeedDatum& other) {
        return other.phi_over_pi != data.front().phi_over_pi;
    };
    if (!std::ranges::any_of(data, is_other))
        throw lines.complaint("E_CSV",
                              data.empty()       ? "no row after the header"
                              : data.size() == 1 ? "one row after the header"
                                                 : "phi_over_pi is the same in all rows",
                              "two rows with different phi_over_pi, at least");
}

}  // namespace

std::vector<CuttingSpeedDatum> parse_cutting_speeds(std::string_view text,
                                                    const std::string& file,
                                                    const ReadLimits& limits)
{
    CsvLines lines{text, file};
    lines.next();  // the header of an empty text has no columns and is refused below
    const NamedColumns columns{lines, names, names.size()};
    require_memory(
        file, static_cast<double>(line_count(lines.rest())) * sizeof(CuttingSpeedDatum),
        limits);
    std::vector<CuttingSpeedDatum> data;
    while (lines.next()) {
        columns.check_row(lines);
        data.push_back(
            {number(lines, columns, 0, 1), number(lines, columns, 1, most_speed)});
    }
    require_spread(data, lines);
    return data;
}

std::vector<CuttingSpeedDatum> read_cutting_speeds(const std::filesystem::path& path,
                                                   const ReadLimits& limits)
{
    return parse_cutting_speeds(read_file(path, limits), shown_path(path), limits);
}

}  // namespace endmill
