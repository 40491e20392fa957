// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "endmill/strategy/detail/covered_part.h"
#include "endmill/strategy/detail/front_march.h"

namespace endmill {

/// How far a straight move may stray from the rolling ball of its pass.
struct MoveLimits {
    /// Height in mm below which the ball of a pass covers the surface beside it.
    double covered_height;
    /// By how much in mm a move may miss what the ball of its pass covers; > 0.
    double cover_slack;
};

/// Divides `pass` into as few straight moves as the limits allow. Each move is clear of
/// the part, and reaches the points that the rolling ball reaches at `covered_height`:
/// the one above each contact and those on both sides of it.
/// \return the pieces of the pass; the pass is interrupted where no move is clear.
/// \param samples of the part on which the pass was laid.
std::vector<LaidPass> divided_into_moves(const LaidPass& pass, const PartSamples& samples,
                                         const CoveredPart& part,
                                         const MoveLimits& limits);

}  // namespace endmill
