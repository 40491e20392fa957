// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "endmill/path/tool_path.h"
#include "endmill/stock/detail/tool_pieces.h"
#include "endmill/stock/dexel_stock.h"

namespace endmill {

/// What a move does to the material on the rays.
struct DexelMove {
    double removed = 0;  ///< mm^3, mean of the bounds and of the three fields
    double deepest = 0;  ///< mm, greatest length removed for certain on a ray
    /// mm, greatest length that may be removed on a ray.
    double most_deep = 0;
    double body_depth = 0;  ///< mm, greatest length in shank or holder for certain
    /// mm, greatest length of material that may be in shank or holder.
    double most_body_depth = 0;
};

/// Material removed by a path from dexels.
struct DexelRemoval {
    std::vector<DexelMove> moves;  ///< one per point of the path
    double removed = 0;            ///< mm^3, mean of the bounds and of the three fields
    double bound = 0;   ///< mm^3, half the difference of the bounds on the rays
    double spread = 0;  ///< mm^3, difference of the fields
};

/// The motions that remove material, and those of shank and holder.
struct DexelMotions {
    const ToolPieces& cutters;
    const ToolPieces& bodies;
    std::size_t points;  ///< number of points of the path
};

/// Removes from `stock`, piece by piece in the order of cutting, what the cutters sweep.
/// Shank and holder are tested on the material before their own piece is cut.
///
/// From the upper set of a ray only intervals that are removed for certain are taken, from
/// the lower set all that may be removed. Ends are rounded outwards to whole units, so that
/// sums are exact. Tiles of 8 by 8 rays are processed on all threads; the result is the same
/// with any number of threads.
/// Source: docs/methods/five-axis-removal.md, section 5.
/// \param progress is called with the finished share, 0 to 1; may be empty.
DexelRemoval remove_from_dexels(DexelStock& stock, const DexelMotions& motions,
                                const std::function<void(double)>& progress = {});

}  // namespace endmill
