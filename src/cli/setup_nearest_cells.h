// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "cli/progress.h"
#include "endmill/core/vec.h"
#include "endmill/visibility/visibility.h"

namespace endmill {

/// As `for_each_nearest_cells`. The ranks of the program take a share of the facets each, as far
/// as that saves time; the result does not depend on their number. Rank 0 calls this function.
/// \param progress shows the work of this rank if it is divided.
/// \throws as `for_each_nearest_cells`; the error of a rank that fails.
void divided_nearest_cells(const VisibilityMap& map, std::span<const Vec3> centres,
                           const NearestCellsVisit& visit, ProgressLine& progress);

/// What the other ranks do meanwhile: find the nearest cells for the facets that rank 0 sends,
/// until the program ends. They hold their share of the facets, and a bit for each two cells.
[[noreturn]] void serve_nearest_cells();

}  // namespace endmill
