// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/path_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/detail/joined_rows.h"

// A path may have millions of points, so the rows are written in parallel and without
// temporary strings (joined_rows.h). Each run of rows has a writer of its own. The text
// of a row depends on the row only, although a writer copies the text of a repeated
// number, so the file does not depend on the number of threads.

namespace endmill {
namespace {

constexpr std::string_view location_columns =
    "pass,point,move,tip_x_mm,tip_y_mm,tip_z_mm,axis_x,axis_y,axis_z";
constexpr std::string_view contact_columns =
    ",u,v,contact_x_mm,contact_y_mm,contact_z_mm,normal_x,normal_y,normal_z";
constexpr std::string_view no_contact_place = ",,,,,";  // u, v, point
constexpr std::string_view no_normal = ",,,";

// Appends the numbers of one column. A number that equals that of the previous row is
// copied as text, which is faster: axes and the parameter of an iso-line rarely change.
class NumberColumn {
public:
    // Appends the number after a comma.
    void append(std::string& text, double value)
    {
        text += ',';
        const std::size_t begin = text.size();
        if (bytes_ > 0 && value == value_) {
            text.append(text, begin_, bytes_);
        } else {
            require(std::isfinite(value), "tool_path_csv: a number is not finite");
            append_text(text, value);
        }
        value_ = value;
        begin_ = begin;
        bytes_ = text.size() - begin;
    }

private:
    double value_ = 0;
    std::size_t begin_ = 0;  // of the text of value_
    std::size_t bytes_ = 0;
};

// Which of the optional columns the file has. A column is written if any point has a
// value.
struct OptionalColumns {
    bool tool = false;
    bool patch = false;
    bool feed = false;
    bool speed = false;
    bool limit = false;
    bool positions = false;  // of a machine
};

// The optional columns that the path needs.
OptionalColumns optional_columns(const ToolPath& path)
{
    OptionalColumns columns;
    columns.positions = path.machine.has_value();
    require(!path.machine || path.machine->positions.size() == path.points.size(),
            "tool_path_csv: need positions of the machine for every point");
    for (const PathPoint& point : path.points) {
        columns.tool |= point.conditions.tool.has_value();
        columns.patch |= point.patch != 0;
        columns.feed |= point.conditions.feed_mm_per_min.has_value();
        columns.speed |= point.conditions.spindle_rpm.has_value();
    }
    return columns;
}

// Writes rows of one run. It remembers the last number of each column (NumberColumn).
class RowWriter {
public:
    explicit RowWriter(const OptionalColumns& columns) : columns_{columns} {}

    // Appends the row of point `i`.
    void append(std::string& text, const ToolPath& path, std::size_t i,
                std::string_view limit)
    {
        const PathPoint& point = path.points[i];
        const CuttingConditions& conditions = point.conditions;
        text += std::to_string(point.pass);
        text += ',';
        text += std::to_string(point.point);
        text += ',';
        text += move_name(point.move);
        append(text, point.location.tip, 0);
        append(text, point.location.axis, 3);
        if (columns_.tool) {
            text += ',';
            text += conditions.tool ? std::to_string(*conditions.tool) : "";
        }
        if (columns_.patch) {
            text += ',';
            text += std::to_string(point.patch);
        }
        if (const SurfaceContact* contact = point.contact()) {
            numbers_[6].append(text, contact->u);
            numbers_[7].append(text, contact->v);
            append(text, contact->contact.point, 8);
        } else {
            text += no_contact_place;
        }
        if (const Vec3* normal = point.normal())
            append(text, *normal, 11);
        else
            text += no_normal;
        if (columns_.feed)
            append(text, conditions.feed_mm_per_min, 14);
        if (columns_.speed)
            append(text, conditions.spindle_rpm, 15);
        if (columns_.limit) {
            text += ',';
            text += limit;
        }
        if (columns_.positions)
            append(text, path.machine->positions[i]);
        text += '\n';
    }

private:
    // Appends the three numbers of a vector from `column` on.
    void append(std::string& text, const Vec3& vector, std::size_t column)
    {
        for (int c = 0; c < 3; ++c)
            numbers_[column + c].append(text, vector[c]);
    }

    // Appends the positions of the machine.
    void append(std::string& text, const AxisPositions& at)
    {
        append(text, at.xyz, 16);
        for (std::size_t k = 0; k < at.rotary.size(); ++k)
            numbers_[19 + k].append(text, Angle::radians(at.rotary[k]).written_degrees());
    }

    // Appends a number, or an empty cell if it is unknown.
    void append(std::string& text, const std::optional<double>& number,
                std::size_t column)
    {
        if (number)
            numbers_[column].append(text, *number);
        else
            text += ',';
    }

    OptionalColumns columns_;
    std::array<NumberColumn, 21> numbers_;
};

// The first line of the file.
std::string header(const OptionalColumns& columns)
{
    std::string line{location_columns};
    line += columns.tool ? ",tool" : "";
    line += columns.patch ? ",patch" : "";
    line += contact_columns;
    line += columns.feed ? ",feed_mm_per_min" : "";
    line += columns.speed ? ",spindle_rpm" : "";
    line += columns.limit ? ",limit" : "";
    line += columns.positions ? ",x_mm,y_mm,z_mm,r1_deg,r2_deg" : "";
    line += '\n';
    return line;
}

using LimitOf = std::function<std::string_view(std::size_t point)>;

// The content of a file: a path, the word of each point if there is a column for it, and
// the columns.
struct Table {
    const ToolPath& path;
    LimitOf limit_of;
    OptionalColumns columns;
};

// The lines of `count` points from `first` on. Each call has a RowWriter of its own, so
// the text does not depend on the division into runs.
std::string rows(const Table& table, std::size_t first, std::size_t count)
{
    RowWriter writer{table.columns};
    std::string text;
    for (std::size_t i = first; i < first + count; ++i)
        writer.append(text, table.path, i,
                      table.columns.limit ? table.limit_of(i) : std::string_view{});
    return text;
}

using Sink = std::function<void(std::string_view piece)>;

// Passes all rows on, made in parallel.
void write_table(const Table& table, const Sink& sink)
{
    sink(header(table.columns));
    pass_rows(
        table.path.points.size(),
        [&](std::size_t first, std::size_t count) { return rows(table, first, count); },
        sink);
}

// Writes all rows in parallel.
std::string table_text(const Table& table)
{
    return joined_rows(
        header(table.columns), table.path.points.size(),
        [&](std::size_t first, std::size_t count) { return rows(table, first, count); });
}

}  // namespace

std::string tool_path_csv(const ToolPath& path)
{
    return table_text({path, {}, optional_columns(path)});
}

std::string tool_path_csv(const ToolPath& path, std::span<const std::string_view> limits)
{
    require(limits.size() == path.points.size(),
            "tool_path_csv: need a limit for every point");
    OptionalColumns columns = optional_columns(path);
    columns.limit = true;
    return table_text({path, [&](std::size_t i) { return limits[i]; }, columns});
}

void write_tool_path_csv(const ToolPath& path, const Sink& sink)
{
    write_table({path, {}, optional_columns(path)}, sink);
}

void write_tool_path_csv(const ToolPath& path, const LimitOf& limit_of, const Sink& sink)
{
    OptionalColumns columns = optional_columns(path);
    columns.limit = true;
    write_table({path, limit_of, columns}, sink);
}

}  // namespace endmill
