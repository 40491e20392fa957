// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "endmill/setup/whole_cone_search.h"

namespace endmill {

/// What `set_search` finds, to the same gap, for parts with more cones that decide than `few`.
/// It is asked for some of them: its bound holds for all, since more cones only forbid poses.
/// Then some of those are added that its pose misses, spread over all that it misses, and it is
/// asked again, until the pose misses none, or the best set about its axis that meets all cones
/// comes within the gap of the greatest bound. Every round has more cones, so that this ends;
/// usually far from all. The same for any number of threads.
/// \param few at least 4: a quarter of it are the cones to begin with, and those added each time.
/// \throws DomainError as `set_search`.
SetSearchResult many_cones_search(const SphereGrid& grid, const VisibilityMap& map,
                                  const SetSearchOptions& options, std::size_t few = 512);

}  // namespace endmill
