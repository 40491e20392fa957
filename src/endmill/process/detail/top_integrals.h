// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "endmill/process/detail/border_integrals.h"

namespace endmill {

/// Contribution to the sums of the stock's top, or of the ball's equator in deeper stock.
/// Closed form over the azimuths engaged there.
/// Source: derived in paper/notes/ball-engagement.md, section 3.
/// \param region the engaged region.
/// \param chip definition of the chip thickness.
/// \param azimuths the engaged azimuths at the latitude of the top.
CoefficientSums top_integrals(const EngagedRegion& region, ChipModel chip,
                              std::span<const AzimuthRange> azimuths);

}  // namespace endmill
