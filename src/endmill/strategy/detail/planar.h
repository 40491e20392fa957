// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "endmill/strategy/detail/covering_path.h"

namespace endmill {

/// The directions of the parameter lines through the middle of each surface, from 0 to below
/// 180 degrees; none for a mesh.
std::vector<Angle> parameter_directions(const Part& part);

/// Directions of passes in parallel upright planes, and what to expect of them.
struct PlanarDirections {
    std::vector<Angle> best;                  ///< the best one first, or the given one
    std::vector<ComparedDirection> compared;  ///< by rising angle; none if it was given
    /// Length of the passes by `options.distance`, mm, found on few samples; nothing if the
    /// direction was given.
    std::optional<double> travel;
};

/// Searches for the directions with the shortest passes by `options.distance`, in steps of 5
/// degrees and then between them. The passes are laid on a coarse net.
/// Source: docs/methods/planar-passes.md, section 2.
/// \param part, cutter, options as below.
/// \param further directions to compare beside those of the search.
PlanarDirections planar_directions(const CoveredPart& part, const BallCutter& cutter,
                                   const StrategyOptions& options,
                                   std::span<const Angle> further);

/// Passes in parallel upright planes.
struct PlanarPasses {
    LaidPasses laid;
    Angle direction;  ///< of the passes, from +x towards +y
};

/// Lays passes in parallel upright planes in the directions on the fine net. Returns the
/// shortest.
/// Source: docs/methods/planar-passes.md.
/// \param part       on whose samples passes are laid.
/// \param cutter     the ball.
/// \param options    height, direction, limits and progress.
/// \param directions to compare, at least one.
/// \throws LimitError if the part needs too many samples.
PlanarPasses planar_passes(const CoveredPart& part, const BallCutter& cutter,
                           const StrategyOptions& options,
                           std::span<const Angle> directions);

}  // namespace endmill
