// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/trimming/detail/profile_families.h"
#include "support/experiment.h"
#include "support/offset_sections.h"

namespace endmill {

/// Adds the crossings that methods 2 and 3 find in the first literal folds of `offset`, one
/// row for method 1 at each of `steps_mm`, and a row with the extremes of all steps. The
/// rows begin with `feed`.
void add_scans(CsvTable& result, const std::string& feed, const OffsetSections& offset,
               const std::vector<double>& steps_mm);

/// Adds the crossings that methods 2 and 3 find in the first literal folds of planar
/// offset curves. \param points of each curve.
void add_planar_folds(CsvTable& result, const std::string& name,
                      const std::vector<OffsetProfile>& profiles, int points);

}  // namespace endmill
