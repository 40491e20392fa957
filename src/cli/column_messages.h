// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/visibility/visibility.h"

namespace endmill {

/// Sends all columns of a map to another rank, as they lie in memory and at most 64 MiB at a
/// time. \pre the map has facets.
void send_columns(int to, const VisibilityMap& map);

/// Receives the columns that another rank sends.
/// \param map has as many facets as theirs.
/// \param share the columns of `map` that they become, in their order.
void receive_columns(int from, VisibilityMap& map, const DirectionShare& share = {});

}  // namespace endmill
