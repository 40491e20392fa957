// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "endmill/setup/detail/minimal_cones.h"
#include "endmill/setup/whole_cone_search.h"

namespace endmill {

/// Branch and bound over the axis of the range of tool directions.
///
/// Nodes are bounded for the working set of the cones. A range about the centre of a node
/// that is better than the best one is checked against all cones; if it misses some, a
/// few of these are added to the working set, and the search goes on with the same nodes.
/// Bounds of a smaller working set remain valid.
///
/// The result does not depend on the number of threads.
/// Source: paper/notes/whole-cones.md, section 8.
/// \param grid cells. \param cones over these cells, at least one; their working set
///         grows. \param options what is minimised, and when the search stops.
WholeConeSearchResult axis_search(const SphereGrid& grid, const MinimalCones& cones,
                                  std::vector<std::size_t> first_cones,
                                  const WholeConeSearchOptions& options);

}  // namespace endmill
