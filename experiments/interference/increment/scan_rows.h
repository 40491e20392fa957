// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "support/experiment.h"
#include "support/offset_sections.h"

namespace endmill {

/// Adds the crossings that methods 2 and 3 find in the first literal folds of `offset`, and
/// one row for method 1 at each of `steps_mm`. The rows begin with `feed`.
void add_scans(CsvTable& result, const std::string& feed, const OffsetSections& offset,
               const std::vector<double>& steps_mm);

}  // namespace endmill
