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

/// The positions of known columns in a table. Columns of other names are refused.
class NamedColumns {
public:
    /// Reads the header, which is the current line of `lines`.
    /// \param names  outlive this object; the table must have the first `needed` of them.
    /// \throws FormatError E_CSV for an unknown, repeated or missing column.
    NamedColumns(const CsvLines& lines, std::span<const std::string_view> names,
                 std::size_t needed);

    /// Whether the table has the column `names[column]`.
    bool has(std::size_t column) const { return places_[column].has_value(); }

    /// Checks that the current line has one cell for each column.
    /// \throws FormatError E_CSV unless it has.
    void check_row(const CsvLines& lines) const;

    /// The cell of the current line. \pre has(column), and check_row has passed.
    std::string_view cell(const CsvLines& lines, std::size_t column) const
    {
        return lines.cells()[*places_[column]];
    }

    /// An error at a cell of the current line. It states the column, the text of the cell
    /// and what is expected.
    FormatError complaint(const CsvLines& lines, std::size_t column,
                          const std::string& expected) const;

private:
    std::span<const std::string_view> names_;
    std::vector<std::optional<std::size_t>> places_;
    std::size_t count_;
};

}  // namespace endmill
