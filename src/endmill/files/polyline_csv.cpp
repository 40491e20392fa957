// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/input_csv.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "endmill/core/text.h"
#include "endmill/files/detail/named_columns.h"
#include "endmill/files/read_file.h"

// The rows of a plane and of a curve stand together, so one pass over the file is enough: a
// change of the column `plane` or `curve` ends a curve and starts the next one. At the end
// the curves of each plane are oriented and sorted (`arranged`), so that the order of
// curves in the file does not matter.

namespace endmill {
namespace {

constexpr std::array<std::string_view, 4> names{"s_mm", "z_mm", "curve", "plane"};
constexpr std::size_t curve_column = 2;
constexpr std::size_t plane_column = 3;

using Curves = std::vector<SectionCurve>;

// The lines of the text, with the header as the current line. The header of an empty text
// has no columns and is refused by NamedColumns.
CsvLines lines_at_header(std::string_view text, const std::string& file)
{
    CsvLines lines{text, file};
    lines.next();
    return lines;
}

// Reads the rows of one file and groups them into planes and curves.
class PolylineReader {
public:
    // Columns other than `known` are refused.
    PolylineReader(std::string_view text, const std::string& file,
                   std::span<const std::string_view> known, const ReadLimits& limits)
        : lines_{lines_at_header(text, file)},
          columns_{lines_, known, 2},
          has_planes_{known.size() > plane_column && columns_.has(plane_column)},
          file_{file},
          limits_{limits}
    {
    }

    // Reads all rows. The memory is checked before, from the number of lines.
    std::vector<Curves> read_all()
    {
        require_memory(
            file_, static_cast<double>(line_count(lines_.rest())) * sizeof(SectionPoint),
            limits_);
        while (lines_.next())
            add_row();
        if (planes_.empty())
            throw lines_.complaint("E_CSV", "no row after the header", "a point");
        finish_curve();
        for (Curves& curves : planes_)
            curves = arranged(std::move(curves));
        return std::move(planes_);
    }

private:
    // Adds the current row to its curve. A point that equals the previous one is merged.
    void add_row()
    {
        columns_.check_row(lines_);
        const std::int64_t plane = has_planes_ ? whole_number(plane_column) : 0;
        if (planes_.empty() || plane != plane_)
            begin_plane(plane);
        const std::int64_t number =
            columns_.has(curve_column) ? whole_number(curve_column) : 0;
        if (planes_.back().empty() || number != number_)
            begin_curve(number);
        const SectionPoint point{length(0), length(1)};
        auto& points = planes_.back().back().points;
        if (points.empty() || points.back() != point)
            points.push_back(point);
    }

    // Starts a new plane; its number must not have occurred before.
    void begin_plane(std::int64_t plane)
    {
        if (!planes_.empty())
            finish_curve();
        if (!plane_numbers_.insert(plane).second)
            throw comes_again("plane", plane);
        plane_ = plane;
        numbers_.clear();
        planes_.emplace_back();
    }

    // Starts a new curve; its number must not have occurred before in its plane.
    void begin_curve(std::int64_t number)
    {
        if (!planes_.back().empty())
            finish_curve();
        if (!numbers_.insert(number).second)
            throw comes_again("curve", number);
        number_ = number;
        first_line_ = lines_.line();
        planes_.back().emplace_back();
    }

    FormatError comes_again(const std::string& what, std::int64_t number) const
    {
        return lines_.complaint(
            "E_CSV",
            what + " " + std::to_string(number) + " occurs again after another " + what,
            "the rows of a " + what + " together");
    }

    // Checks the last curve and decides whether it is closed.
    void finish_curve()
    {
        SectionCurve& curve = planes_.back().back();
        if (curve.points.size() < 2)
            throw FormatError{
                "E_CSV",
                {file_, std::to_string(first_line_),
                 "a curve with " + counted(curve.points.size(), "different point"),
                 "two or more"}};
        curve.is_closed = curve.points.front() == curve.points.back();
    }

    // The number of the current row's curve or plane.
    std::int64_t whole_number(std::size_t column) const
    {
        const std::string_view text = columns_.cell(lines_, column);
        std::int64_t number = 0;
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, number);
        if (error != std::errc{} || stop != end || number < 0)
            throw columns_.complaint(lines_, column, "a whole number from 0");
        return number;
    }

    // A coordinate of the current row, within the limit.
    double length(std::size_t column) const
    {
        const auto number = number_from_text(columns_.cell(lines_, column));
        if (!number)
            throw columns_.complaint(lines_, column, "a number");
        if (std::abs(*number) > limits_.max_extent_mm)
            throw lines_.complaint(
                "E_RANGE", std::string{names[column]} + " is " + to_text(*number),
                "at most " + to_text(limits_.max_extent_mm) + " mm (--max-extent)");
        return *number;
    }

    CsvLines lines_;
    NamedColumns columns_;
    bool has_planes_;
    const std::string& file_;
    const ReadLimits& limits_;
    std::vector<Curves> planes_;
    std::set<std::int64_t> plane_numbers_;
    std::set<std::int64_t> numbers_;  // of the curves of the current plane
    std::int64_t plane_ = 0;
    std::int64_t number_ = 0;
    std::size_t first_line_ = 0;  // line of the first point of the current curve
};

}  // namespace

std::vector<SectionCurve> parse_polylines(std::string_view text, const std::string& file,
                                          const ReadLimits& limits)
{
    return PolylineReader{text, file, std::span{names}.first(plane_column), limits}
        .read_all()
        .front();
}

std::vector<SectionCurve> read_polylines(const std::filesystem::path& path,
                                         const ReadLimits& limits)
{
    return parse_polylines(read_file(path, limits), shown_path(path), limits);
}

std::vector<std::vector<SectionCurve>> parse_polyline_planes(std::string_view text,
                                                             const std::string& file,
                                                             const ReadLimits& limits)
{
    return PolylineReader{text, file, names, limits}.read_all();
}

std::vector<std::vector<SectionCurve>> read_polyline_planes(
    const std::filesystem::path& path, const ReadLimits& limits)
{
    return parse_polyline_planes(read_file(path, limits), shown_path(path), limits);
}

}  // namespace endmill
