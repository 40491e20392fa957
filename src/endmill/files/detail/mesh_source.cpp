// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/mesh_source.h"

#include <cmath>
#include <limits>

#include "endmill/core/text.h"

namespace endmill {
namespace {

// Points and triangles are indexed by std::int32_t.
constexpr std::uint64_t most_numbers = std::numeric_limits<std::int32_t>::max();

// A coordinate as messages show it.
std::string shown(double value)
{
    if (std::isnan(value))
        return "NaN";
    if (std::isinf(value))
        return value > 0 ? "infinity" : "-infinity";
    return to_text(value);
}

// Whether a coordinate in mm is finite and within the limit.
bool is_within(double mm, const ReadLimits& limits)
{
    return std::isfinite(mm) && std::abs(mm) <= limits.max_extent_mm;
}

// Throws the error about a coordinate. A converted coordinate is stated in both units.
[[noreturn]] void refuse_coordinate(const MeshSource& source, double value,
                                    FilePlace place)
{
    const std::string found = "coordinate " + shown(value);
    if (!std::isfinite(value))
        throw complaint(source, "E_NONFINITE", place, found, "a finite number");
    const std::string converted =
        source.mm_per_unit == 1 ? "" : " (" + shown(source.mm_per_unit * value) + " mm)";
    throw complaint(
        source, "E_RANGE", place, found + converted,
        "at most " + shown(source.limits.max_extent_mm) + " mm (--max-extent)");
}

}  // namespace

// The fast path is one comparison for each coordinate; the error is made separately.
Vec3 point_mm(const MeshSource& source, const Vec3& coordinates, FilePlace place)
{
    Vec3 point = source.mm_per_unit * coordinates;
    for (int c = 0; c < 3; ++c)
        if (!is_within(point[c], source.limits))
            refuse_coordinate(source, coordinates[c], place);
    return point;
}

Vec3 scan_point_mm(TextScanner& scanner, const MeshSource& source)
{
    Vec3 coordinates;
    for (int c = 0; c < 3; ++c)
        coordinates[c] = scanner.number();
    return point_mm(source, coordinates, FilePlace::line(scanner.line()));
}

std::int32_t point_number(const MeshSource& source, std::int64_t number,
                          std::size_t points, FilePlace place)
{
    if (number < 0 || number >= static_cast<std::int64_t>(points))
        throw complaint(source, "E_INDEX", place, "index " + std::to_string(number),
                        points == 0 ? "no index: there are no points"
                                    : "0 to " + std::to_string(points - 1));
    return static_cast<std::int32_t>(number);
}

void require_numbers(const MeshSource& source, std::uint64_t points_or_triangles)
{
    if (points_or_triangles > most_numbers)
        throw LimitError{source.file + ": " + std::to_string(points_or_triangles) +
                         " points or triangles; the limit is 2147483647"};
}

FormatError complaint(const MeshSource& source, const std::string& code, FilePlace place,
                      const std::string& found, const std::string& expected)
{
    return FormatError{code, {source.file, place.text(), found, expected}};
}

}  // namespace endmill
