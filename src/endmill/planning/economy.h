// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "endmill/path/tool_path.h"
#include "endmill/surface/surface_jet.h"

namespace endmill {

/// A length by the two points of the cutter that one may follow.
struct Travel {
    double contact_mm;  ///< of the chords between contacts, as the paper's tables count
    double tip_mm;      ///< of the cutter's tip, as the machine moves
};

/// What a path costs.
struct PathEconomy {
    std::size_t passes;  ///< runs of points that share their `pass`
    std::size_t ncl;     ///< CL points: those at which the cutter touches the part
    Travel cut;          ///< along the passes
    Travel link;         ///< between them, at feed; lifted moves are in neither
};

/// Counts the points of `path` and sums the straight moves between them.
/// Source: [KimChoi, section 4.3], NCL and TCD.
///
/// \param path any; nothing costs nothing.
/// \throws DomainError if a cut or link does not lead from one contact to another.
/// The counts are exact; the relative error of a length is below 1.2e-16 (n + 4) for n
/// moves.
PathEconomy path_economy(const ToolPath& path);

/// How plans along u and along v compare.
struct DirectionComparison {
    Parameter
        recommended;  ///< the shorter one; of equals the one with fewer points, then u
    double reduction_ncl;  ///< (max - min) / max of the points, from 0 to below 1
    double reduction_tcd;  ///< (max - min) / max of the travel, likewise
};

/// Points and travel of one direction.
struct DirectionCost {
    std::size_t ncl;  ///< number of CL points
    double tcd_mm;    ///< travel, by contacts or by tips as the caller counts it
};

/// Compares planning along u with planning along v.
/// Source: [KimChoi, section 4.3 and the head of table 1].
///
/// \throws DomainError unless all four numbers are positive and finite.
/// The choice is exact; relative error of a reduction below 4e-16 for counts below 2^53.
DirectionComparison compare_directions(const DirectionCost& u, const DirectionCost& v);

}  // namespace endmill
