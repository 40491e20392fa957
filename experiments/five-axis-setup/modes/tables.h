// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "support/named_cells.h"
#include "support/studied_part.h"

namespace endmill {

/// A search over whole cones, named as in params.json.
struct WholeConeSearch {
    std::string family;     ///< CA or AB
    std::string objective;  ///< floored-area, total-range or tilt
    double gap;             ///< required: best <= (1 + gap) bound
};

/// Columns of `mode_cells`.
std::vector<std::string> mode_columns();

/// The least objective over whole cones, and the objective at the poses of least area of
/// `paper` and `corrected`, in degrees (`floored-area` in square degrees). Without
/// limits. Then paper_over_set, the ratio of the first to the least; ranges_below_mar, the
/// number of ranges at the pose of the least objective that are smaller than those at the
/// pose of `paper`; and paper_on_that_machine, whether `paper` finds a pose on a machine
/// with exactly the ranges of the pose of the least objective.
NamedCells mode_cells(const StudiedPart& part, const WholeConeSearch& search);

}  // namespace endmill
