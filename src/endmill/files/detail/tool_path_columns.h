// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string_view>

#include "endmill/files/detail/csv_lines.h"

namespace endmill {

/// A column of a tool path, in the order in which they are written.
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
};

inline constexpr std::size_t path_column_count = 22;  ///< all of them

/// The name of a column in a file.
std::string_view column_name(PathColumn column);

/// The column so many places after `column` in the enumeration.
constexpr PathColumn following(PathColumn column, int places)
{
    return static_cast<PathColumn>(static_cast<std::size_t>(column) +
                                   static_cast<std::size_t>(places));
}

/// Where the columns of a file stand.
class PathColumns {
public:
    PathColumns() { places_.fill(missing); }  ///< none

    /// Whether the file has it.
    bool has(PathColumn column) const { return place(column) != missing; }
    bool has_contacts() const;  ///< u, v, contact and normal

    /// From 0. \pre has(column)
    std::size_t place(PathColumn column) const
    {
        return places_[static_cast<std::size_t>(column)];
    }

    std::size_t count() const { return count_; }  ///< of the file

    /// The next column of the file. \return false if it stands there already.
    bool add(PathColumn column);

private:
    static constexpr std::size_t missing = std::numeric_limits<std::size_t>::max();

    std::array<std::size_t, path_column_count> places_;
    std::size_t count_ = 0;
};

/// The columns that the line names at which `lines` stands.
/// \throws FormatError E_CSV unless they are known, each named once, with those of the tip,
///         and all of a vector or none.
PathColumns path_columns(const CsvLines& lines);

}  // namespace endmill
