// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "endmill/surface/continuity.h"

namespace endmill {

/// Continuity of a part of several surfaces: within each as `continuity` says, and where
/// sides of two surfaces (or of one) meet. Two sides of patches meet if their ends are
/// the same two points to 1e-6 of the part's size, in either order; their parameters may
/// run differently. A side that meets no other is a border of the part. The angle is that
/// by which the part turns across the border, 180 degrees where it folds back. What 17
/// samples a side show is held to the limits of `border_breaks`.
///
/// `worst.surface` counts from 0. \throws DomainError if there are no surfaces.
SurfaceContinuity continuity(std::span<const Surface> surfaces);

}  // namespace endmill
