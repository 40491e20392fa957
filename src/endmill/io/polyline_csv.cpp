// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/io/polyline_csv.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>

#include "endmill/core/numbers.h"
#include "endmill/interference/curve_arrangement.h"
#include "endmill/io/csv_lines.h"
#include "endmill/io/printable.h"
#include "endmill/io/read_file.h"

namespace endmill {
namespace {

constexpr std::size_t longest_echo = 40;
constexpr std::array<std::string_view, 3> names{"s_mm", "z_mm", "curve"};

class PolylineReader {
public:
    PolylineReader(std::string_view text, const std::string& file,
                   const ReadLimits& limits)
        : lines_{text, file},
          file_{file},
          limits_{limits}
    {
    }

    std::vector<SectionCurve> read_all()
    {
        lines_.next();  // an empty text has no columns
        read_header();
        require_memory(
            file_, static_cast<double>(line_count(lines_.rest())) * sizeof(SectionPoint),
            limits_);
        while (lines_.next())
            add_row();
        if (curves_.empty())
            throw lines_.complaint("E_CSV", "no row after the header", "a point");
        finish_curve();
        return arranged(std::move(curves_));
    }

private:
    void read_header()
    {
        for (std::size_t place = 0; place < lines_.cells().size(); ++place) {
            const std::string_view word = lines_.cells()[place];
            const auto known = std::ranges::find(names, word);
            if (known == names.end())
                throw lines_.complaint(
                    "E_CSV", "unknown column \"" + printable(word, longest_echo) + '"',
                    "s_mm, z_mm and optionally curve");
            auto& column = columns_[static_cast<std::size_t>(known - names.begin())];
            if (column)
                throw lines_.complaint("E_CSV", "column " + std::string{word} + " twice",
                                       "each once");
            column = place;
        }
        for (const std::size_t needed : {0, 1})
            if (!columns_[needed])
                throw lines_.complaint("E_CSV", "no column " + std::string{names[needed]},
                                       "s_mm and z_mm");
    }

    void add_row()
    {
        const std::size_t expected = columns_[2] ? 3 : 2;
        if (lines_.cells().size() != expected)
            throw lines_.complaint("E_CSV",
                                   "row has " + counted(lines_.cells().size(), "cell"),
                                   std::to_string(expected));
        const std::int64_t number = columns_[2] ? curve_number() : 0;
        if (curves_.empty() || number != number_)
            begin_curve(number);
        const SectionPoint point{length(0), length(1)};
        auto& points = curves_.back().points;
        if (points.empty() || points.back() != point)
            points.push_back(point);
    }

    void begin_curve(std::int64_t number)
    {
        if (!curves_.empty())
            finish_curve();
        if (!numbers_.insert(number).second)
            throw lines_.complaint(
                "E_CSV", "curve " + std::to_string(number) + " again, after another",
                "the rows of a curve together");
        number_ = number;
        first_line_ = lines_.line();
        curves_.emplace_back();
    }

    void finish_curve()
    {
        SectionCurve& curve = curves_.back();
        if (curve.points.size() < 2)
            throw FormatError{
                "E_CSV",
                {file_, std::to_string(first_line_),
                 "a curve with " + counted(curve.points.size(), "different point"),
                 "two or more"}};
        curve.is_closed = curve.points.front() == curve.points.back();
    }

    std::int64_t curve_number() const
    {
        const std::string_view text = lines_.cells()[*columns_[2]];
        std::int64_t number = 0;
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, number);
        if (error != std::errc{} || stop != end || number < 0)
            refuse(2, "a whole number from 0");
        return number;
    }

    double length(std::size_t column) const
    {
        const auto number = number_from_text(lines_.cells()[*columns_[column]]);
        if (!number)
            refuse(column, "a number");
        if (std::abs(*number) > limits_.max_extent_mm)
            throw lines_.complaint(
                "E_RANGE", std::string{names[column]} + " is " + to_text(*number),
                "at most " + to_text(limits_.max_extent_mm) + " mm (--max-extent)");
        return *number;
    }

    [[noreturn]] void refuse(std::size_t column, const std::string& expected) const
    {
        const std::string_view text = lines_.cells()[*columns_[column]];
        const std::string found =
            text.empty() ? "empty" : '"' + printable(text, longest_echo) + '"';
        throw lines_.complaint("E_CSV", std::string{names[column]} + " is " + found,
                               expected);
    }

    CsvLines lines_;
    const std::string& file_;
    const ReadLimits& limits_;
    std::array<std::optional<std::size_t>, 3> columns_{};  // as `names`
    std::vector<SectionCurve> curves_;
    std::set<std::int64_t> numbers_;
    std::int64_t number_ = 0;
    std::size_t first_line_ = 0;  // of the last curve
};

}  // namespace

std::vector<SectionCurve> parse_polylines(std::string_view text, const std::string& file,
                                          const ReadLimits& limits)
{
    return PolylineReader{text, file, limits}.read_all();
}

std::vector<SectionCurve> read_polylines(const std::filesystem::path& path,
                                         const ReadLimits& limits)
{
    return parse_polylines(read_file(path, limits), shown_path(path), limits);
}

}  // namespace endmill
