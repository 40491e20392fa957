// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "endmill/setup/detail/direction_fan.h"
#include "endmill/setup/detail/setup_order.h"

namespace endmill {

/// Sectors of 180 degrees or more that end at the same direction of a fan, with the same
/// largest polar angles.
struct WideSectors {
    std::size_t earliest;  ///< index of the direction at which the widest begins
    std::size_t begin;     ///< index of the direction at which the narrowest begins
    std::size_t end;       ///< index of the direction at which all end
    double inside;         ///< rad, largest polar angle of the directions in the sector
    double outside;        ///< rad, largest polar angle of the others, 0 if there is none
};

/// The wide sectors of a fan that may be the best by any score that grows with the width
/// and the largest polar angles: at most four for each direction. O(n log n).
///
/// A sector is left out if another one that begins at the same or at a later direction is
/// not wider, and neither of its polar angles is larger.
std::vector<WideSectors> least_wide_sectors(const DirectionFan& fan);

/// Offers wide sectors to `best`, so that it finds the same sector as if each sector of
/// 180 degrees or more, from each direction to each direction, were offered in the order
/// of begins, then of ends.
/// \param fan directions. \param sectors from `least_wide_sectors`.
/// \param is_allowed which sectors may be offered. It must allow each sector that is not
///        wider and not higher than an allowed one.
void offer_wide_sectors(const DirectionFan& fan, const std::vector<WideSectors>& sectors,
                        const std::function<bool(const SectorCandidate&)>& is_allowed,
                        BestCandidate<SectorCandidate>& best);

}  // namespace endmill
