// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/input_csv.h"

#include <array>
#include <cmath>

#include "endmill/core/angle.h"
#include "endmill/core/text.h"
#include "endmill/files/detail/named_columns.h"
#include "endmill/files/read_file.h"

namespace endmill {
namespace {

constexpr std::array<std::string_view, 2> names{"azimuth_deg", "polar_deg"};
constexpr double whole_turn_deg = 360;
constexpr double most_polar_deg = 180;

// The unit vector of the current row. The azimuth is reduced to half a turn either way
// first, which is exact and keeps the accuracy of large angles.
Vec3 direction(const CsvLines& lines, const NamedColumns& columns)
{
    const auto azimuth_deg = number_from_text(columns.cell(lines, 0));
    if (!azimuth_deg)
        throw columns.complaint(lines, 0, "a number");
    const auto polar_deg = number_from_text(columns.cell(lines, 1));
    if (!polar_deg || !(*polar_deg >= 0 && *polar_deg <= most_polar_deg))
        throw columns.complaint(lines, 1, "a number from 0 to 180");
    const double azimuth =
        Angle::degrees(std::remainder(*azimuth_deg, whole_turn_deg)).radians();
    const double polar = Angle::degrees(*polar_deg).radians();
    return {std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
            std::cos(polar)};
}

}  // namespace

std::vector<Vec3> parse_directions(std::string_view text, const std::string& file,
                                   const ReadLimits& limits)
{
    CsvLines lines{text, file};
    lines.next();  // the header of an empty text has no columns and is refused below
    const NamedColumns columns{lines, names, names.size()};
    require_memory(file, static_cast<double>(line_count(lines.rest())) * sizeof(Vec3),
                   limits);
    std::vector<Vec3> directions;
    while (lines.next()) {
        columns.check_row(lines);
        directions.push_back(direction(lines, columns));
    }
    if (directions.empty())
        throw lines.complaint("E_CSV", "no row after the header", "a direction");
    return directions;
}

std::vector<Vec3> read_directions(const std::filesystem::path& path,
                                  const ReadLimits& limits)
{
    return parse_directions(read_file(path, limits), shown_path(path), limits);
}

}  // namespace endmill
