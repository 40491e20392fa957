// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "endmill/files/csv.h"
#include "support/experiment.h"

namespace endmill {

/// The rows of result.csv: what the decoded numbers imply, the null test of the interpretation with the
/// scaling kept, the curves that fulfil target 1, and a small search by cells.
/// Parameters: see params.json.
CsvTable short_result(Experiment& run);

/// Adds the best surfaces of the long search to `result`, from the CSV file `surfaces` with the columns
/// name, family, policies and values: their cells against the print and their score by criterion.md, and
/// writes the contacts of their passes to the output for the figures.
void add_best_surfaces(CsvTable& result, Experiment& run,
                       const std::filesystem::path& surfaces);

}  // namespace endmill
