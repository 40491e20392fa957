// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/files/csv.h"
#include "support/judged_path.h"

namespace endmill {

/// An empty table of judged paths: column `row`, then one column for each measure of
/// `JudgedPath`.
CsvTable judged_table();

/// Plans over `surface` along u and v by both planners, judges the four paths and appends
/// them. The tolerance is the default of `plan` for this ball.
/// \param name of the surface, for the labels.
void add_judged_paths(CsvTable& table, const std::string& name, const Surface& surface,
                      const BallCutter& ball);

}  // namespace endmill
