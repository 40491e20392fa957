// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "endmill/deviation/detail/part_tiles.h"
#include "endmill/stock/height_stock.h"

namespace endmill {

/// What was missing below the part, before a path, of a stock of which heights alone are
/// known.
struct EarlierGouge {
    bool is_of_heights = false;  ///< there is such a stock
    double found_mm =
        0;  ///< depth along the part's normal that the heights tell for certain
    std::optional<Vec3> found_at = {};  ///< on the part, mm; none without depth
    double bound_mm =
        0;  ///< none is deeper by more, but for what is narrower than a cell
};

/// That of `stock`, by the rays at the middles of the tiles' cells. Along them more may
/// show than counts of it: a place of the part beside them may be nearer.
/// The result is the same for every number of threads. For the bound see `most_missing`.
EarlierGouge earlier_gouge(const PartCharts& charts, std::span<const PartTile> tiles,
                           const HeightStock& stock);

}  // namespace endmill
