// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/strategy/detail/covering_path.h"

namespace endmill {

/// Lays passes along level lines of the guide field of the part.
/// Source: docs/methods/field-passes.md, section 3.
/// \param part    the part.
/// \param cutter  the ball.
/// \param options height, distance, limits.
/// \throws LimitError if the part needs more samples than the guide field can have.
LaidPasses field_passes(const CoveredPart& part, const BallCutter& cutter,
                        const StrategyOptions& options);

/// The length of the passes of field_passes by `options.distance`, mm, from passes on few
/// samples.
/// \param part, cutter, options as above.
double field_travel(const CoveredPart& part, const BallCutter& cutter,
                    const StrategyOptions& options);

}  // namespace endmill
