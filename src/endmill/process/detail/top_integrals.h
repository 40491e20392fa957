// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/process/detail/border_integrals.h"

namespace endmill {

/// What the stock's top adds to the sums, or the ball's equator where the stock is
/// higher: closed, over the azimuths engaged there.
/// Source: derived in paper/notes/ball-engagement.md, section 3.
CoefficientSums top_integrals(const EngagedRegion& region, ChipModel chip);

}  // namespace endmill
