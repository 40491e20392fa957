// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/files/csv.h"
#include "support/judged_path.h"

namespace endmill {

/// An empty table of judged paths: `row` first, a column for each measure of `JudgedPath`.
CsvTable judged_table();

/// Plans over `surface` along u and v, as the paper and verified, with the tolerance that
/// `plan` takes by default for this ball, and appends the four judged paths.
/// \param name of the surface, for the labels.
void add_judged_paths(CsvTable& table, const std::string& name, const Surface& surface,
                      const BallCutter& ball);

}  // namespace endmill
