// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "economic-cl-data/acceptance/acceptance.h"
#include "endmill/files/csv.h"

namespace endmill {

/// Columns of the table of `Acceptance`: the measures, then whether each item holds.
std::vector<std::string> acceptance_columns();

/// The row of the surface `name`. \param printed the cells to compare with.
std::vector<CsvCell> acceptance_row(const std::string& name, const Acceptance& found,
                                    const EconomyTables& printed);

}  // namespace endmill
