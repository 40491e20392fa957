// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/tool_path_columns.h"

#include <algorithm>
#include <optional>
#include <string>

#include "endmill/core/text.h"

namespace endmill {
namespace {

constexpr std::size_t longest_echo = 40;
constexpr std::array<std::string_view, path_column_count> names{
    "pass",     "point",           "move",         "tip_x_mm",     "tip_y_mm", "tip_z_mm",
    "axis_x",   "axis_y",          "axis_z",       "tool",         "patch",    "u",
    "v",        "contact_x_mm",    "contact_y_mm", "contact_z_mm", "normal_x", "normal_y",
    "normal_z", "feed_mm_per_min", "spindle_rpm",  "limit",        "x_mm",     "y_mm",
    "z_mm",     "r1_deg",          "r2_deg"};

// Units at the end of the names of lengths, feeds, speeds and angles.
constexpr std::array<std::string_view, 4> units{"_mm", "_mm_per_min", "_rpm", "_deg"};

// Neighbouring columns that form a vector or a pair.
struct Vector {
    PathColumn first;
    int columns;
};

using enum PathColumn;

// Columns that a file has all or none of.
constexpr std::array vectors{Vector{TipX, 3},       Vector{AxisX, 3},
                             Vector{U, 2},          Vector{ContactX, 3},
                             Vector{NormalX, 3},    Vector{AxisPositionX, 3},
                             Vector{FirstRotary, 2}};

// A name in quotes, for messages.
std::string quoted(std::string_view name)
{
    return '"' + printable(name, longest_echo) + '"';
}

// The column of this name; nothing if there is none.
std::optional<PathColumn> column_named(std::string_view name)
{
    const auto found = std::ranges::find(names, name);
    if (found == names.end())
        return std::nullopt;
    return static_cast<PathColumn>(found - names.begin());
}

// Whether `name` is the known name `known` without its unit.
bool is_without_unit(std::string_view name, std::string_view known)
{
    return std::ranges::any_of(units, [&](std::string_view unit) {
        return known.ends_with(unit) &&
               known.substr(0, known.size() - unit.size()) == name;
    });
}

// The columns that a tool path must have, and those that it may have.
std::string expected_columns()
{
    std::string optional;
    for (const std::string_view name : names)
        if (!name.starts_with("tip_"))
            optional += (optional.empty() ? "" : ", ") + std::string{name};
    return "tip_x_mm, tip_y_mm and tip_z_mm, and any of " + optional;
}

// Whether `name` is a letter that names a coordinate, without the point and the unit.
bool is_coordinate(std::string_view name)
{
    constexpr std::array<std::string_view, 6> letters{"x", "y", "z", "X", "Y", "Z"};
    return std::ranges::find(letters, name) != letters.end();
}

// Refuses an unknown name and suggests a known one: the name with its unit, or a close
// name.
[[noreturn]] void refuse_name(const CsvLines& lines, std::string_view name)
{
    if (name.empty())
        throw lines.complaint("E_CSV", "a column without a name", "a name for each");
    for (const std::string_view known : names)
        if (is_without_unit(name, known) && !is_coordinate(name))
            throw lines.complaint("E_CSV", "column " + quoted(name) + " without its unit",
                                  quoted(known));
    if (is_coordinate(name))
        throw lines.complaint("E_CSV", "unknown column " + quoted(name),
                              expected_columns() +
                                  "; x, y and z of the tip are tip_x_mm, tip_y_mm and "
                                  "tip_z_mm, those of the contact contact_x_mm ...");
    const auto closest = closest_word(name, names);
    throw lines.complaint(
        "E_CSV", "unknown column " + quoted(name),
        expected_columns() +
            (closest ? "; did you mean " + quoted(*closest) + "?" : std::string{}));
}

// Checks that every vector has all its columns or none, and that the tip has all.
void check_vectors(const CsvLines& lines, const PathColumns& columns)
{
    for (const Vector& vector : vectors) {
        int known = 0;
        PathColumn missing = vector.first;
        for (int c = vector.columns - 1; c >= 0; --c)
            if (columns.has(following(vector.first, c)))
                ++known;
            else
                missing = following(vector.first, c);
        if (vector.first == TipX && known < vector.columns)
            throw lines.complaint("E_CSV", "no column " + quoted(column_name(missing)),
                                  "a header with tip_x_mm, tip_y_mm and tip_z_mm");
        if (0 < known && known < vector.columns)
            throw lines.complaint("E_CSV", "no column " + quoted(column_name(missing)),
                                  "all columns of a vector, or none");
    }
}

}  // namespace

std::string_view column_name(PathColumn column)
{
    return names[static_cast<std::size_t>(column)];
}

bool PathColumns::has_contacts() const
{
    return has(U) && has(ContactX) && has(NormalX);
}

bool PathColumns::has_positions() const
{
    return has(AxisPositionX) && has(FirstRotary);
}

bool PathColumns::add(PathColumn column)
{
    if (has(column))
        return false;
    places_[static_cast<std::size_t>(column)] = count_++;
    return true;
}

PathColumns path_columns(const CsvLines& lines)
{
    PathColumns columns;
    for (const std::string_view name : lines.cells()) {
        const std::optional<PathColumn> column = column_named(name);
        if (!column)
            refuse_name(lines, name);
        if (!columns.add(*column))
            throw lines.complaint("E_CSV", "two columns named " + quoted(name), "one");
    }
    check_vectors(lines, columns);
    return columns;
}

}  // namespace endmill
