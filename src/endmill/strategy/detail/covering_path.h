// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/strategy/detail/covered_part.h"
#include "endmill/strategy/strategy_options.h"

namespace endmill {

/// Share of the scallop height at which passes are laid out. The rest is for what lies
/// between samples and for the chords of moves.
inline constexpr double layout_share = 0.98;

/// Passes, and the samples on which they are laid.
struct LaidPasses {
    PartSamples samples;
    std::vector<LaidPass> passes;
};

/// Makes a path from passes. It divides them into few straight moves, bends passes towards
/// places that their moves miss, and orders and links the pieces.
/// \param laid    passes that cover the samples at `layout_share` of the scallop height.
/// \param part    on whose samples they were laid.
/// \param cutter  the ball.
/// \param options height, tolerance, links and progress.
/// \throws GeometryError if the ball fits nowhere.
CoveringPath covering_path(LaidPasses laid, const CoveredPart& part,
                           const BallCutter& cutter, const StrategyOptions& options);

}  // namespace endmill
