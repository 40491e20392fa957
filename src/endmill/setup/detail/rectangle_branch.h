// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>

#include "endmill/machine/rotary_limits.h"
#include "endmill/setup/detail/pole_points.h"
#include "endmill/setup/detail/rectangle_candidate.h"

namespace endmill {

/// How far above the certain bound a search over R1 may end, relative, or below a square degree
/// in parts of that: far below a cell's width, 0.1 rad.
inline constexpr double branch_accuracy = 1e-7;

/// What a search over R1 is for.
struct BranchGoal {
    std::optional<RotaryLimits> limits{};  ///< of alpha and beta, signed, or none
    double worthless = std::numeric_limits<double>::infinity();  ///< rad^2: larger areas
};

/// The best of R1 at every fifth degree: a quick upper bound.
std::optional<RectangleCandidate> coarse_rectangle(const PolePoints& points,
                                                   const BranchGoal& goal);

/// The rectangle of least area, to 1e-7 of it (or, below a square degree, of that), of all
/// positions of R1, wherever the directions lie; alpha is the principal value, so that no
/// rectangle reaches across +-180 degrees. Nothing if none fits, or if all are certainly
/// worthless. A direction within 1e-9 rad of R1, or of its opposite, has alpha 0. A fit within
/// limits that holds for less than 1e-12 rad of R1 may be missed, but not one that
/// `coarse_rectangle` finds. The same for any worth that its area equals or is below.
///
/// Branch and bound over the azimuth of R1. With R1 at azimuth psi a direction (x, y, z) has
/// s = x sin psi - y cos psi, tan alpha = s / z and sin beta = x cos psi + y sin psi. Within
/// half a turn an extent of beta, and for z >= 0 one of alpha, is least at an end; for z < 0,
/// where s keeps its sign between the direction's azimuths, |alpha| is least where |s| is
/// largest. The product of the sums of such least extents bounds a piece from below, and so does
/// one of a few directions that lacks the square of the piece's width only. Derived in
/// paper/notes/rectangle-about-an-axis.md.
/// \pre the directions have unit length; `points` is not empty.
std::optional<RectangleCandidate> branch_rectangle(const PolePoints& points,
                                                   const BranchGoal& goal);

}  // namespace endmill
