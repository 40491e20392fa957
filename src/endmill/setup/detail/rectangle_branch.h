// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>

#include "endmill/machine/axis_limits.h"
#include "endmill/setup/detail/pole_points.h"
#include "endmill/setup/detail/rectangle_candidate.h"

namespace endmill {

/// The goal of a search over R1.
struct BranchGoal {
    /// Signed limits of alpha (phi) and beta (theta).
    std::optional<RotaryLimits> limits{};
    /// rad^2: larger areas are of no interest.
    double worthless = std::numeric_limits<double>::infinity();
};

/// The best rectangle with R1 at a multiple of 5 degrees, as a quick upper bound.
/// \param points directions, of unit length. \param goal limits; `worthless` has no
///         effect.
/// \return nothing if no such rectangle fits the limits.
std::optional<RectangleCandidate> coarse_rectangle(const PolePoints& points,
                                                   const BranchGoal& goal);

/// Finds the rectangle of least area over all positions of R1, to `branch_accuracy`.
/// Directions may lie anywhere on the sphere.
///
/// alpha is the principal value, so that no rectangle reaches across 180 degrees. A
/// direction within 1e-9 rad of R1 or its opposite has alpha 0. A rectangle that fits the
/// limits only for an interval of R1 below 1e-12 rad may be missed, unless
/// `coarse_rectangle` finds it. The result is the same for every `worthless` that is not
/// below its area.
///
/// Method: branch and bound over the azimuth of R1, with the bounds of RectangleNeeds.
/// Source: paper/notes/rectangle-about-an-axis.md, section 4.
/// \param points directions, of unit length, at least one. \param goal limits and worth.
/// \return nothing if no rectangle fits the limits, or if all areas exceed `worthless`.
std::optional<RectangleCandidate> branch_rectangle(const PolePoints& points,
                                                   const BranchGoal& goal);

}  // namespace endmill
