// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "endmill/files/csv.h"

namespace endmill {

/// "yes" or "no".
CsvCell word(bool holds);

/// Cells with the names of their columns.
using NamedCells = std::vector<std::pair<std::string, CsvCell>>;

/// Adds a row to a table whose first column is `row`. Columns that `cells` does not name
/// stay empty.
/// \throws DomainError if it names a column that the table does not have.
void add_named(CsvTable& table, const std::string& row, const NamedCells& cells);

/// The cells of `one`, then those of `other`.
NamedCells joined(NamedCells one, const NamedCells& other);

}  // namespace endmill
