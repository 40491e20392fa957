// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "five-axis-setup/teapot-grids/tables.h"

namespace endmill {

/// The teapot on one grid, and the setups found there.
struct GridSetups {
    StudiedPart part;
    std::vector<FoundSetup> setups;
};

/// Columns of the functions below.
std::vector<std::string> comparison_columns();

/// The best poses of a mode on all grids: least_tilt_deg and largest_tilt_deg of the tool
/// axis; grids_lean_to_x, on how many of them it leans to +x; worst_over_corrected, the
/// largest ratio of the area to that of `corrected`; in A,B also worst_true_over_claimed,
/// the largest ratio of the area that the pose needs to the one that the mode claims.
NamedCells spread_cells(const std::vector<GridSetups>& grids, const std::string& family,
                        const std::string& mode);

/// The best poses of the mode `paper` on the grids of this many cells. axes_apart_deg: the
/// largest angle between the tool axes of two grids; as the part is symmetric in y, the
/// nearer of an axis and its mirror image counts. grids_that_agree: on how many of these
/// grids the mode finds the part machinable with the ranges of the pose of the first grid.
NamedCells agreement_cells(const std::vector<GridSetups>& grids,
                           const std::string& family, std::size_t cells);

/// poses_feasible: the number of cells that as tool axis have a rectangle of the mode
/// `paper` within the limits of a machine of family A,B. poses: the number of cells.
/// setup_decides: whether some of them do, but not all.
/// \param r1_deg, r2_deg lower and upper limit.
NamedCells machine_cells(const StudiedPart& part, const std::vector<double>& r1_deg,
                         const std::vector<double>& r2_deg);

}  // namespace endmill
