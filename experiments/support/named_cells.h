// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "endmill/files/csv.h"

namespace endmill {

/// "yes" or "no".
CsvCell word(bool holds);

/// Cells by the columns that they belong to.
using NamedCells = std::vector<std::pair<std::string, CsvCell>>;

/// Adds a row to a table whose first column is `row`; columns that `cells` does not name stay
/// empty. \throws DomainError if it names one that the table has not.
void add_named(CsvTable& table, const std::string& row, const NamedCells& cells);

/// All cells of both, one after the other.
NamedCells joined(NamedCells one, const NamedCells& other);

}  // namespace endmill
