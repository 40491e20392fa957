// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "endmill/files/csv.h"
#include "endmill/planning/detail/integer_decoding.h"

namespace endmill {

/// Settings of the null test.
struct NullTestPlan {
    std::vector<double> tolerances_mm;  ///< one test for each
    int triples;                        ///< see null_test
    std::uint32_t seed;                 ///< see null_test
};

/// Table of the interpretations, one a line, in this order: of the six printed rows; of
/// the row v, 0.5 mm, with 1008 instead of 1009 (the one edit with which the rows agree)
/// and with 828 instead of 820 (the count in the caption of [KimChoi, fig. 13]), the
/// latter within the widest tolerance of the null test; combinations over the three
/// tolerances with one chord length; the null tests.
CsvTable decoding_csv(const EconomyTables& printed, const DecodingRules& rules,
                      const NullTestPlan& null);

}  // namespace endmill
