// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/named_cells.h"
#include "support/studied_part.h"

namespace endmill {

/// What a tool's body leaves of the cones of a part: accessible_entries; lost_percent, the
/// share of those of `bare` that it takes; empty_cones; left_by_best_direction, the facets
/// that the best single direction does not reach; ca_area_deg2 and ab_area_deg2, the least
/// areas of the mode `corrected`. \param bare the part without the body.
NamedCells body_cells(const StudiedPart& part, const StudiedPart& bare);

}  // namespace endmill
