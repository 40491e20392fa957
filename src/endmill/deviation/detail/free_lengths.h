// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/deviation/detail/part_distance.h"

namespace endmill {

/// Radius of the largest ball that touches the part at the foot of a way and contains no
/// other place of the part: up to this length the foot is the nearest place of the part.
struct FreeLength {
    double length;  ///< mm
    /// Whether the length was measured. Otherwise it is an upper bound, up to the error
    /// of the part's triangulation.
    bool is_measured;
};

/// Returns the free lengths of ways whose feet lie near each other.
///
/// Only some are measured. A place of the part that limits a measured length also limits
/// its neighbours: the ball that touches a neighbour's foot and passes through this place
/// bounds the neighbour's length from above. The bound is close because it is stationary
/// at the place that limits the length. A length that is not measured is therefore too
/// long by about 1 % at most, except where another piece of the part limits it.
/// Source: paper/notes/deviation-bounds.md, "All rays count so".
/// \param hint as in `PartDistance`.
std::vector<FreeLength> free_lengths(std::span<const PartWay> ways,
                                     const PartDistance& distance,
                                     std::optional<std::size_t>& hint);

}  // namespace endmill
