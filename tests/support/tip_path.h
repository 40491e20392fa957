// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/path/tool_path.h"

namespace endmill::test {

/// Returns a path through `tips` with one kind of move.
inline ToolPath tip_path(const std::vector<Vec3>& tips, Move move = Move::Cut)
{
    ToolPath path;
    for (const Vec3& tip : tips)
        path.points.push_back({.pass = 0,
                               .point = static_cast<int>(path.points.size()),
                               .move = move,
                               .location = {tip, Vec3::UnitZ()}});
    return path;
}

}  // namespace endmill::test
