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
/// limits.
NamedCells mode_cells(const StudiedPart& part, const WholeConeSearch& search);

}  // namespace endmill
