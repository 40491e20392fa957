// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/planning/verified_plan.h"

namespace endmill {

/// The passes over one surface, v rising, and the places between them that are not known
/// to be covered.
struct VerifiedStrips {
    std::vector<VerifiedPass> passes;  ///< none of them empty
    std::vector<SurfacePoint> uncovered;
};

/// Lays passes along u over all of a surface and cuts them into steps, as plan_verified
/// says.
/// \param clear of the whole part, at the inner tolerance.
/// \throws as plan_verified.
VerifiedStrips verified_strips(const MarchedSurface& marched, const ClearMoves& clear,
                               const VerifiedOptions& options);

}  // namespace endmill
