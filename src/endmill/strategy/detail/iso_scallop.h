// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/strategy/detail/covering_path.h"
#include "endmill/strategy/detail/starts.h"

namespace endmill {

/// Starts of passes of equal scallop height, and what to expect of them.
struct ScallopStarts {
    std::vector<MarchStart> best;  ///< the best one first
    /// Length of the passes by `options.distance`, mm: that of the best start on few samples.
    double travel;
};

/// Tries the starts of the march on few samples.
/// \param part, cutter, options as below.
ScallopStarts scallop_starts(const CoveredPart& part, const BallCutter& cutter,
                             const StrategyOptions& options);

/// Lays passes of equal scallop height: each as far as possible from the passes before it.
/// On a part of many samples they are laid from the best start. Otherwise the best few are
/// compared.
/// Source: docs/methods/iso-scallop.md, section 2.
/// \param part     on whose samples passes are laid.
/// \param cutter   the ball.
/// \param options  height, limits and progress.
/// \param starts   from scallop_starts.
/// \throws LimitError if the part needs too many samples.
LaidPasses iso_scallop_passes(const CoveredPart& part, const BallCutter& cutter,
                              const StrategyOptions& options,
                              const ScallopStarts& starts);

}  // namespace endmill
