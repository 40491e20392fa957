// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "endmill/files/csv.h"
#include "endmill/planning/detail/table_search.h"

namespace endmill {

/// The policies of a text such as "alternate none": words for the choices that differ from the planner's
/// defaults. alternate; none, half, border; free; stop; normal, first-pass; dense-min, mean, first, max; tip;
/// cuts; single; diameter (taken for the radius); chord.
/// \throws DomainError for another word.
RunPolicies policies_of(const std::string& text);

/// One search.
struct SearchCase {
    std::string name;  ///< unique, also a file name
    /// "cells", "stages", or "curve-u" and "curve-v" for the first stage alone.
    std::string method;
    /// The cells that are searched, see searched_tables:
    /// "print";
    /// "null-N", without structure (null A);
    /// "net-NAME-N", of a fitted net with heights changed by up to 5 mm (null B);
    /// "planted-N", of a random surface of the family, for stages with passes like those of the print;
    /// "planted+WORDS-N", the same planned with these words of `policies` besides.
    /// For stages only:
    /// "renumbered-N", the interpretation of the print with other numbers of passes of the same scatter;
    /// "regular-N", the same with a small scatter also in the row v, 1 mm;
    /// "irregular-planted-N", planted with a run v, 1 mm, 15 mm as irregular as that of the print;
    /// "noisy-planted-N", planted with one pass more, one less or none in each run;
    /// "less-TABLE", one of these without the row v, 1 mm;
    /// "targets-N", numbers of points and lengths near those of the print (first stage only).
    std::string table;
    std::string family;    ///< see family_name
    std::string policies;  ///< see policies_of
    std::uint32_t seed;    ///< of the search
    int evaluations;  ///< of surfaces, per search or box; of curves for the first stage alone
    int curves;  ///< wanted of each curve; number of searches for the first stage alone
    double most_height;  ///< of a curve, mm; not for cells
};

/// The values of a fit as search_table has them: the word "values" and numbers.
std::vector<double> values_of(const std::string& text);

/// A table of results, without rows.
CsvTable search_table();

/// Runs a case. \return search_table with one row.
CsvTable run_case(const SearchCase& search);

}  // namespace endmill
