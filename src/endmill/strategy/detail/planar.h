// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/strategy/detail/covering_path.h"

namespace endmill {

/// Passes in parallel upright planes.
struct PlanarPasses {
    LaidPasses laid;
    Angle direction;                          ///< of the passes, from +x towards +y
    std::vector<ComparedDirection> compared;  ///< by rising angle; none if it was given
};

/// Lays passes in parallel upright planes, in the given direction or in the best one: the
/// one with the shortest passes by `options.distance`. The best direction is searched for
/// on a coarse net, in steps of 5 degrees and then between them; the best few are laid on
/// the fine net.
/// Source: docs/methods/planar-passes.md.
/// \param part     surfaces and the sides of the tool.
/// \param cutter   the ball.
/// \param options  height, direction, limits and progress.
/// \throws LimitError if the part needs too many samples.
PlanarPasses planar_passes(const CoveredPart& part, const BallCutter& cutter,
                           const StrategyOptions& options);

}  // namespace endmill
