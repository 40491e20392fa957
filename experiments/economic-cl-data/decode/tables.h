// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "endmill/files/csv.h"
#include "endmill/planning/detail/integer_decoding.h"

namespace endmill {

/// What the null test is run with.
struct NullTestPlan {
    std::vector<double> tolerances_mm;  ///< a test for each
    int triples;                        ///< see null_test
    std::uint32_t seed;                 ///< see null_test
};

/// The readings of the six printed rows as a table: a line a reading; then those of the
/// row v, 0.5 mm, with 1008 in place of 1009 (the one edit that makes it agree) and with
/// 828 in place of 820 (the count in the caption of [KimChoi, fig. 13]), the latter
/// within the widest tolerance of the null test; then the combinations of readings over
/// the three tolerances that have one chord length; then the null tests.
CsvTable decoding_csv(const EconomyTables& printed, const DecodingRules& rules,
                      const NullTestPlan& null);

}  // namespace endmill
