// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "support/named_cells.h"
#include "support/studied_part.h"

namespace endmill {

/// A search over whole cones, by the words of a params.json.
struct WholeConeSearch {
    std::string family;     ///< CA or AB
    std::string objective;  ///< floored-area, total-range or tilt
    double gap;             ///< to be proved: best <= (1 + gap) bound
};

/// Columns of `mode_cells`.
std::vector<std::string> mode_columns();

/// What is least over whole cones beside what the same objective is at the poses of least area
/// of `paper` and `corrected`: in degrees, `floored-area` in square degrees. Without limits.
NamedCells mode_cells(const StudiedPart& part, const WholeConeSearch& search);

}  // namespace endmill
