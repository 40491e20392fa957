// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "endmill/planning/detail/clear_moves.h"
#include "endmill/planning/detail/contact_line.h"
#include "endmill/planning/detail/strip_cover.h"
#include "endmill/planning/linking.h"

namespace endmill {

/// How far the ball's straight motions may stray, in mm.
struct MotionTolerances {
    double inner;  ///< into the part, anywhere
    double outer;  ///< material left along the pass, along the part's normal
};

/// A surface to plan on, and what its moves are judged by. All outlive it.
struct VerifiedSurface {
    const MarchedSurface& marched;
    const ClearMoves& clear;       ///< of the whole part, at `tolerances.inner`
    const StripCover& line_cover;  ///< at the height `tolerances.outer`
    MotionTolerances tolerances;
    Parameter direction;
    bool stop_at_borders;  ///< a CL point on every patch border
    std::size_t most_points;

    const BallCutter& cutter() const { return clear.cutter(); }
};

/// A place beside a pass that its ball must reach.
struct CoverDemand {
    double foot_u;  ///< where on the pass
    Vec3 point;     ///< mm; to be within R of the centre's move there
};

/// A pass in the pieces that the ball can cut, u rising. None if it fits nowhere.
struct VerifiedPass {
    double v;
    std::vector<Pass> pieces;
};

/// The pass along u at `v` in the longest steps, to a thousandth of each, whose straight
/// motions keep the tolerances and reach all `demands` (u rising). Where not even a step
/// of 1e-4 of a patch does, or the ball does not fit, the pass breaks off, and goes on
/// where it can.
/// \throws GeometryError where the surface has no normal; LimitError beyond `most_points`.
VerifiedPass verified_pass(const VerifiedSurface& surface, double v,
                           std::span<const CoverDemand> demands);

/// The straight moves of a pass's pieces.
SweptPass swept(const VerifiedPass& pass, const BallCutter& cutter);

/// Puts a contact into the middle, by its parameter, of the step that is number `step` of
/// `swept(pass)`.
/// \return whether the halves still keep the tolerances; if not, `pass` is as before.
bool halve_step(VerifiedPass& pass, std::size_t step, const VerifiedSurface& surface);

}  // namespace endmill
