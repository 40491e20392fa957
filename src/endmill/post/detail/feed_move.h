// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/core/vec.h"
#include "endmill/path/tool_path.h"

namespace endmill {

/// Kind of a straight move at feed, derived from its ends because a program does not
/// state it: straight down is a plunge, straight up a retract, anything else a cut.
/// Source: docs/methods/removal.md, section 5.
inline Move feed_move(const Vec3& from, const Vec3& to)
{
    if (from.x() != to.x() || from.y() != to.y() || from.z() == to.z())
        return Move::Cut;
    return to.z() < from.z() ? Move::Plunge : Move::Retract;
}

}  // namespace endmill
