// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "endmill/path/tool_path.h"
#include "endmill/surface/parameter.h"

namespace endmill {

/// A length by the two points of the cutter that one may follow.
struct Travel {
    double contact_mm;  ///< of the chords between contacts, as the paper's tables count
    double tip_mm;      ///< of the cutter's tip, as the machine moves
};

/// What a path costs.
struct PathEconomy {
    std::size_t passes;
    std::size_t ncl;  ///< CL points: those at which the cutter touches the part
    Travel cut;       ///< along the passes
    Travel link;      ///< between them, at feed; lifted moves are in neither
};

/// Counts and sums over `path`.
/// Source: [KimChoi, section 4.3], NCL and TCD.
PathEconomy path_economy(const ToolPath& path);

/// How plans along u and along v compare.
struct DirectionComparison {
    Parameter
        recommended;  ///< the shorter one; of equals the one with fewer points, then u
    double reduction_ncl;  ///< (max - min) / max of the points
    double reduction_tcd;  ///< (max - min) / max of the travel
};

/// Points and travel of one direction.
struct DirectionCost {
    std::size_t ncl;
    double tcd_mm;
};

/// Compares the two directions.
/// Source: [KimChoi, section 4.3 and the head of table 1].
/// \throws DomainError unless all four numbers are positive.
DirectionComparison compare_directions(const DirectionCost& u, const DirectionCost& v);

}  // namespace endmill
