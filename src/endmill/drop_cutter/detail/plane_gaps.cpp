// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/plane_gaps.h"

#include <algorithm>

#include "endmill/drop_cutter/clearance.h"

namespace endmill {

PlaneGaps plane_gaps(std::span<const Surface> surfaces, const Cutter& cutter,
                     std::span<const std::vector<std::vector<Vec3>>> planes,
                     double allowed_gouge)
{
    PlaneGaps gaps;
    for (const auto& lines : planes) {
        std::vector<Vec3> references;
        for (const std::vector<Vec3>& line : lines)
            references.insert(references.end(), line.begin(), line.end());
        gaps.points += references.size();
        const auto found = least_gap(surfaces, cutter, references);
        if (!found)
            continue;
        gaps.least = std::min(gaps.least, found->gap);
        gaps.gouging_planes += found->gap < -allowed_gouge ? 1 : 0;
    }
    return gaps;
}

}  // namespace endmill
