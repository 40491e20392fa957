// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "support/named_cells.h"
#include "support/studied_part.h"

namespace endmill {

/// Savings by the paper's two groups of facets and by one cell for each cone: means over
/// all cells as tool axis. Source: [KangSuh, eq. (3), (4)].
struct SetupSavings {
    double group_1_percent;     ///< share of facets that need no rotary motion
    double group_2_mean;        ///< number of the other facets
    double nearest_cells_mean;  ///< number of different cells that represent these
};

/// The savings on this part. \pre it has a facet, and the grid a cell.
SetupSavings setup_savings(const StudiedPart& part);

/// Sizes of the cones: facets, empty_cones, accessible_entries.
NamedCells cone_cells(const StudiedPart& part);

/// blocked_percent: the share of the entries of `local`, the cones by incidence only, that
/// other facets of the part block.
NamedCells blocked_cells(const StudiedPart& part, const StudiedPart& local);

/// change_with_group_1: the relative change of the least area of C,A in the mode `paper`
/// if the facets that the tool axis reaches are represented too, by the tool axis.
NamedCells group_1_cells(const StudiedPart& part);

/// Savings of the paper's method: group_1_percent, group_2_mean, nearest_cells_mean;
/// left_by_best_direction, the number of facets that the best single direction does not
/// reach; and ca_paper_area_deg2, the least area of C,A in the mode `paper`.
NamedCells saving_cells(const StudiedPart& part);

}  // namespace endmill
