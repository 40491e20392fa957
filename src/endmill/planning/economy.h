// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "endmill/path/tool_path.h"
#include "endmill/surface/surface_jet.h"

/// \file
/// The cost of a path, and the comparison of the two feed directions.

namespace endmill {

/// A path length, measured at two points of the cutter.
struct Travel {
    double contact_mm;  ///< sum of the chords between contacts, as in the paper's tables
    double tip_mm;      ///< path length of the tip, which the machine travels
};

/// The cost of a path.
struct PathEconomy {
    std::size_t passes;  ///< number of runs of points with the same `pass`
    /// Number of CL points: where the cutter touches the part, and at corners of links.
    std::size_t ncl;
    Travel cut;   ///< along the passes
    Travel link;  ///< straight links between passes; lifted moves are not counted
};

/// Counts the points of `path` and sums the straight moves between them.
/// Source: [KimChoi, section 4.3], NCL and TCD.
///
/// \param path any path; an empty path has cost zero.
/// \throws DomainError if a cut, or the moves of a link, do not lead from one contact to
///         another.
///
/// The counts are exact; the relative error of a length is below 1.2e-16 (n + 4) for n
/// moves.
PathEconomy path_economy(const ToolPath& path);

/// The points of the cutter between which travel is measured.
enum class TravelKind {
    Contact,  ///< chords between contacts
    Tip,      ///< the tip of the cutter, as the machine travels
};

/// The moves whose length counts as travel.
enum class CountedMoves {
    CutsAndLinks,  ///< passes and the straight links between them
    Cuts,          ///< passes only
};

/// Travel of a path in mm.
/// \param economy of the path.
/// \param kind    points between which travel is measured.
/// \param moves   moves that count.
double counted_travel(const PathEconomy& economy, TravelKind kind, CountedMoves moves);

/// Comparison of plans along u and along v.
struct DirectionComparison {
    /// The direction with the shorter travel. If both are equal, the one with fewer
    /// points; if these are equal too, u.
    Parameter recommended;
    double reduction_ncl;  ///< (max - min) / max of the number of points, in [0, 1)
    double reduction_tcd;  ///< (max - min) / max of the travel, in [0, 1)
};

/// Number of points and travel of the plan along one direction.
struct DirectionCost {
    std::size_t ncl;  ///< number of CL points
    double tcd_mm;    ///< travel, by contacts or by tips as the caller chooses
};

/// Compares planning along u with planning along v.
/// Source: [KimChoi, section 4.3, table 1].
///
/// \param u cost of the plan along u.
/// \param v cost of the plan along v.
/// \throws DomainError unless all four numbers are positive and finite.
///
/// The choice is exact; relative error of a reduction below 4e-16 for counts below 2^53.
DirectionComparison compare_directions(const DirectionCost& u, const DirectionCost& v);

}  // namespace endmill
