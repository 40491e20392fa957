// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Paths of straight passes for the tests of neighbouring passes.

#include <span>
#include <vector>

#include "endmill/path/tool_path.h"

namespace endmill {

/// A straight pass, given by its tips in mm.
struct Pass {
    Vec3 from;
    Vec3 to;
};

/// `lines` one way, each in `moves` equal cuts, with a plunge to its start.
inline ToolPath passes(const std::vector<Pass>& lines, int moves)
{
    ToolPath path;
    for (std::size_t k = 0; k < lines.size(); ++k)
        for (int i = 0; i <= moves; ++i) {
            const Vec3 tip = lines[k].from + (lines[k].to - lines[k].from) * i / moves;
            path.points.push_back({static_cast<int>(k),
                                   i,
                                   i == 0 ? Move::Plunge : Move::Cut,
                                   0,
                                   {tip, Vec3::UnitZ()}});
        }
    return path;
}

}  // namespace endmill
