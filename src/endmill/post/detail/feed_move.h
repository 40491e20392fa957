// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/core/vec.h"
#include "endmill/path/tool_path.h"

namespace endmill {

/// What a move at feed is, of which a program says no more: straight down a plunge,
/// straight up a retract, else a cut.
/// Source: spec of the removal, section 5.
inline Move feed_move(const Vec3& from, const Vec3& to)
{
    if (from.x() != to.x() || from.y() != to.y() || from.z() == to.z())
        return Move::Cut;
    return to.z() < from.z() ? Move::Plunge : Move::Retract;
}

}  // namespace endmill
