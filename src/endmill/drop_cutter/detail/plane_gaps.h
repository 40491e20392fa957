// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// The gaps between a cutter and the part along the lines of several planes.
struct PlaneGaps {
    std::size_t points = 0;  ///< number of positions of all planes
    /// smallest gap in mm; infinite without a position
    double least = std::numeric_limits<double>::infinity();
    std::size_t gouging_planes = 0;  ///< number of planes with a gap below the limit
};

/// Measures the least gap in each plane, see `least_gap`.
/// \param surfaces the part.
/// \param cutter the cutter.
/// \param planes for each plane its lines of reference points, mm.
/// \param allowed_gouge in mm; a plane gouges if its least gap is below -allowed_gouge.
/// \throws DomainError as least_gap does.
PlaneGaps plane_gaps(std::span<const Surface> surfaces, const Cutter& cutter,
                     std::span<const std::vector<std::vector<Vec3>>> planes,
                     double allowed_gouge);

}  // namespace endmill
