// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "endmill/deviation/detail/part_tiles.h"
#include "endmill/stock/height_stock.h"
#include "endmill/verification/verification_result.h"

namespace endmill {

/// Measures the gouge in `stock` along the rays at the middles of the tiles' cells.
///
/// The depth along a ray may overestimate a gouge where another place of the part is
/// nearer. `most_missing` gives the bound. The result is the same with any number of
/// threads.
EarlierGouge earlier_gouge(const PartCharts& charts, std::span<const PartTile> tiles,
                           const HeightStock& stock);

}  // namespace endmill
