// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/strategy/detail/covering_path.h"

namespace endmill {

/// Lays passes of equal scallop height: each as far as possible from the passes before it.
/// Several starts are tried on few samples, and the best of them on many. The result with
/// the shortest passes is returned.
/// Source: docs/methods/iso-scallop.md, section 2.
/// \param part     on whose samples passes are laid.
/// \param cutter   the ball.
/// \param options  height, limits and progress.
/// \throws LimitError if the part needs too many samples.
LaidPasses iso_scallop_passes(const CoveredPart& part, const BallCutter& cutter,
                              const StrategyOptions& options);

}  // namespace endmill
