// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "endmill/setup/whole_cone_search.h"

namespace endmill {

/// The search over whole cones for parts with many minimal cones. The result has the same
/// gap as that of `whole_cone_search`.
///
/// One branch and bound begins with some of the cones. Its bounds hold for all cones,
/// because further cones only exclude poses. Every range that it finds is checked against
/// all cones; cones that a node's range or window misses are added to the node and its
/// parts. So each node takes a few hundred cones into account, out of tens of thousands.
///
/// The result does not depend on the number of threads.
/// \param grid cells. \param map cones over these cells. \param options as
///         `whole_cone_search`.
/// \param few at least 4. With at most so many minimal cones every node takes all of them.
///         Else the first nodes begin with a quarter of this number.
/// \throws DomainError as `whole_cone_search`, or if `few` is below 4.
WholeConeSearchResult many_cones_search(const SphereGrid& grid, const VisibilityMap& map,
                                        const WholeConeSearchOptions& options,
                                        std::size_t few = 512);

}  // namespace endmill
