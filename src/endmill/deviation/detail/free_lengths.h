// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/deviation/detail/part_distance.h"

namespace endmill {

/// How far one comes along a way while no other place of the part is nearer than its foot.
struct FreeLength {
    double length;     ///< mm
    bool is_measured;  ///< else no less than it is, but for the part's triangulation
};

/// The free lengths of ways whose feet lie near each other. Only some are measured: where
/// those nearby have found other places of the part, the balls that touch a foot and go
/// through these bound its free length from above, and closely, as the place that bounds a
/// free length is one where that bound is stationary. So what is not measured is too
/// long by about 1 % at most, but where it is another piece of the part that bounds it.
/// \param hint as in PartDistance.
std::vector<FreeLength> free_lengths(std::span<const PartWay> ways,
                                     const PartDistance& distance,
                                     std::optional<std::size_t>& hint);

}  // namespace endmill
