// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "economic-cl-data/lost-surface/search_case.h"
#include "endmill/planning/detail/table_search.h"

/// \file
/// The tables that are searched, named by SearchCase::table, with what the search in stages is given of them.

namespace endmill {

/// The interpretation of the printed tables by experiments/economic-cl-data/decode, with the tolerances of
/// the lengths of criterion.md.
DecodedTables printed_decoding();

/// The cells that a case searches.
EconomyTables searched_tables(const SearchCase& search);

/// A random surface of a family whose tables have about the size of the print.
struct PlantedSurface {
    std::vector<double> values;  ///< of the family, then h / delta
    EconomyTables tables;        ///< its cells, TCD rounded as in print
};

/// The planted surface of a case whose table is "planted-N".
PlantedSurface planted_surface(const SearchCase& search);

/// The interpretation that the search in stages is given: of the print, that of a renumbered table, or the
/// true numbers of a planted one.
DecodedTables decoding_of(const SearchCase& search);

/// The numbers of a pass that the first stage alone searches: those of the print, or of "targets-N".
CurveTarget searched_target(const SearchCase& search, int curve);

}  // namespace endmill
