// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "endmill/setup/whole_cone_search.h"

namespace endmill {

/// The search over whole cones for parts with many minimal cones. The result has the same
/// gap as that of `whole_cone_search`.
///
/// 1. `whole_cone_search` runs for some of the cones. Its lower bound holds for all
///    cones, because further cones only exclude poses.
/// 2. If its pose meets all cones, the search ends. It also ends if the best range about
///    the axis of this pose that meets all cones is within the gap of the largest bound.
/// 3. Otherwise some of the cones that the pose misses are added, and step 1 is repeated.
///    Every round has more cones, so that the search ends, usually with far fewer than
///    all.
///
/// The result does not depend on the number of threads.
/// \param grid cells. \param map cones over these cells. \param options as
///         `whole_cone_search`.
/// \param few at least 4. With at most so many minimal cones one search takes all of
///         them. Else a quarter of this number are the first cones, and as many are added
///         in each round.
/// \throws DomainError as `whole_cone_search`, or if `few` is below 4.
WholeConeSearchResult many_cones_search(const SphereGrid& grid, const VisibilityMap& map,
                                        const WholeConeSearchOptions& options,
                                        std::size_t few = 512);

}  // namespace endmill
