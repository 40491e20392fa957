// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "endmill/files/csv.h"
#include "endmill/planning/detail/economy_tables.h"

namespace endmill {

/// The 36 cells that the paper prints, read from the published.csv of the experiments
/// economic-cl-data/table-1 and table-2.
EconomyTables printed_tables();

/// Label of a table's row: "NAME d=TOLERANCE u" or "NAME d=TOLERANCE v".
std::string table_row_label(const std::string& name, double tolerance_mm,
                            Parameter direction);

/// Named tables: first "print", then one for each surface of datasets/surfaces in `names`, as
/// planned by `policies`.
std::vector<std::pair<std::string, EconomyTables>> print_and_nets(
    std::span<const std::string> names, const TablePolicies& policies = {});

/// One of the two tables of the paper for each of `tables`, in the printed layout, with the
/// reductions in percent: between u and v, and from the smallest to the largest ball.
CsvTable economy_csv(std::span<const std::pair<std::string, EconomyTables>> tables,
                     TableQuantity quantity);

}  // namespace endmill
