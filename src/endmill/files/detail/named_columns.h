// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/files/detail/csv_lines.h"

namespace endmill {

/// Where the columns of a table stand that has no others.
class NamedColumns {
public:
    /// Reads the header, the line at which `lines` stands.
    /// \param names outlive this; the first `needed` of them must be there.
    /// \throws FormatError E_CSV for an unknown column, one that is named twice or missing.
    NamedColumns(const CsvLines& lines, std::span<const std::string_view> names,
                 std::size_t needed);

    /// Whether the table has the column of that number among the names.
    bool has(std::size_t column) const { return places_[column].has_value(); }

    /// \throws FormatError E_CSV unless the line has a cell for each column.
    void check_row(const CsvLines& lines) const;

    /// The cell of the line. \pre has(column), and the row was checked.
    std::string_view cell(const CsvLines& lines, std::size_t column) const
    {
        return lines.cells()[*places_[column]];
    }

    /// An error at a cell: which column holds what instead of `expected`.
    FormatError complaint(const CsvLines& lines, std::size_t column,
                          const std::string& expected) const;

private:
    std::span<const std::string_view> names_;
    std::vector<std::optional<std::size_t>> places_;
    std::size_t count_;
};

}  // namespace endmill
