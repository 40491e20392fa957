// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "economic-cl-data/lost-surface/search_case.h"
#include "endmill/files/detail/case_results.h"

namespace endmill {

/// The searches in a CSV file with the columns case, method, table, family, policies, seed, evaluations,
/// curves and most_height_mm. A `table` that ends with N..M, such as null-1..100, stands for one search
/// for each number; its cases have the number at their ends.
/// \throws FormatError for a malformed file.
std::vector<SearchCase> read_cases(const std::filesystem::path& file);

/// Runs the cases of a shard whose results are not yet in `folder`, as write_missing_results. The result
/// of a case is the file NAME.csv.
/// \return number of cases run.
int run_missing_cases(const std::vector<SearchCase>& cases, const CaseShard& shard,
                      const std::filesystem::path& folder);

/// The results of all cases in `folder`, in the order of the cases, with the distance of the fits of planted tables
/// from the planted surfaces.
/// \throws FormatError if one is missing.
CsvTable collected_results(const std::vector<SearchCase>& cases,
                           const std::filesystem::path& folder);

}  // namespace endmill
