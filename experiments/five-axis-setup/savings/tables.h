// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "support/named_cells.h"
#include "support/studied_part.h"

namespace endmill {

/// What the paper's two groups and its one cell a cone save, means over all cells as tool axis.
/// Source: [KangSuh, eq. (3), (4)].
struct SetupSavings {
    double group_1_percent;     ///< facets that need no rotary motion
    double group_2_mean;        ///< the others, by number
    double nearest_cells_mean;  ///< different cells that represent these
};

/// The savings on this part. \pre it has a facet, and the grid a cell.
SetupSavings setup_savings(const StudiedPart& part);

/// What the cones hold: facets, empty_cones, accessible_entries.
NamedCells cone_cells(const StudiedPart& part);

/// What the paper's method saves: group_1_percent, group_2_mean, nearest_cells_mean; and
/// left_by_best_direction, the facets that no single direction reaches with all others, and
/// ca_paper_area_deg2, the least area of C,A in the mode `paper`.
NamedCells saving_cells(const StudiedPart& part);

}  // namespace endmill
