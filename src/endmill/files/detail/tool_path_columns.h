// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string_view>

#include "endmill/files/detail/csv_lines.h"

namespace endmill {

/// The columns of a tool path, in the order in which `tool_path_csv` writes them.
enum class PathColumn : std::size_t {
    Pass,
    Point,
    MoveWord,
    TipX,
    TipY,
    TipZ,
    AxisX,
    AxisY,
    AxisZ,
    Tool,
    Patch,
    U,
    V,
    ContactX,
    ContactY,
    ContactZ,
    NormalX,
    NormalY,
    NormalZ,
    Feed,
    Speed,
    Limit,
    AxisPositionX,
    AxisPositionY,
    AxisPositionZ,
    FirstRotary,
    SecondRotary,
};

inline constexpr std::size_t path_column_count = 27;  ///< number of PathColumn values

/// The name of a column in a file.
std::string_view column_name(PathColumn column);

/// The column `places` after `column` in the enumeration.
constexpr PathColumn following(PathColumn column, int places)
{
    return static_cast<PathColumn>(static_cast<std::size_t>(column) +
                                   static_cast<std::size_t>(places));
}

/// The positions of the columns in a file.
class PathColumns {
public:
    PathColumns() { places_.fill(missing); }  ///< of a file without columns

    /// Whether the file has the column.
    bool has(PathColumn column) const { return place(column) != missing; }
    bool has_contacts() const;   ///< whether it has u, v, contact and normal
    bool has_positions() const;  ///< whether it has all positions of a machine

    /// Position of the column in the file, from 0. \pre has(column)
    std::size_t place(PathColumn column) const
    {
        return places_[static_cast<std::size_t>(column)];
    }

    std::size_t count() const { return count_; }  ///< number of columns in the file

    /// Adds the next column of the file. \return false if the file has it already.
    bool add(PathColumn column);

private:
    static constexpr std::size_t missing = std::numeric_limits<std::size_t>::max();

    std::array<std::size_t, path_column_count> places_;
    std::size_t count_ = 0;
};

/// Reads the header, which is the current line of `lines`.
/// \throws FormatError E_CSV for an unknown or repeated name, a missing column of the
///         tip, and a vector that lacks a column.
PathColumns path_columns(const CsvLines& lines);

}  // namespace endmill
