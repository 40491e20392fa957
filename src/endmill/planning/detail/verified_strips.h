// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/planning/detail/verified_pass.h"
#include "endmill/planning/planner_options.h"

namespace endmill {

/// The passes over one surface, and the places between them that are not proved to be
/// covered.
struct VerifiedStrips {
    std::vector<VerifiedPass> passes;     ///< v rising; each has at least one piece
    std::vector<SurfacePoint> uncovered;  ///< at most one between two neighbouring passes
};

/// Plans the passes along u over one surface; see plan_verified.
/// \param marched the surface.
/// \param clear   of the whole part, at the inner tolerance.
/// \param options those of plan_verified.
/// \throws GeometryError where the surface has no normal.
/// \throws LimitError if there are more than `most_points` points.
VerifiedStrips verified_strips(const MarchedSurface& marched, const ClearMoves& clear,
                               const VerifiedOptions& options);

}  // namespace endmill
