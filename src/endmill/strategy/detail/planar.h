// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "endmill/strategy/detail/covering_path.h"

namespace endmill {

/// Passes in parallel upright planes.
struct PlanarPasses {
    LaidPasses laid;
    Angle direction;                          ///< of the passes, from +x towards +y
    std::vector<ComparedDirection> compared;  ///< by rising angle; none if it was given
};

/// The directions of the parameter lines through the middle of each surface, from 0 to below
/// 180 degrees; none for a mesh.
std::vector<Angle> parameter_directions(const Part& part);

/// Lays passes in parallel upright planes, in the given direction or in the best one: the
/// one with the shortest passes by `options.distance`. The best direction is searched for
/// on a coarse net, in steps of 5 degrees and then between them; the best few are laid on
/// the fine net.
/// Source: docs/methods/planar-passes.md.
/// \param part    on whose samples passes are laid.
/// \param cutter  the ball.
/// \param options height, direction, limits and progress.
/// \param further directions to compare beside those of the search.
/// \throws LimitError if the part needs too many samples.
PlanarPasses planar_passes(const CoveredPart& part, const BallCutter& cutter,
                           const StrategyOptions& options,
                           std::span<const Angle> further);

}  // namespace endmill
