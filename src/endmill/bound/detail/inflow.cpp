// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/inflow.h"

namespace endmill {

std::vector<StoredFlow> stored_flows(std::span<const BoundaryFlow> boundary,
                                     const DensityGrid& grid)
{
    std::vector<StoredFlow> flows;
    flows.reserve(boundary.size());
    for (const BoundaryFlow& piece : boundary) {
        const auto x = static_cast<float>(piece.flow.x());
        const auto y = static_cast<float>(piece.flow.y());
        if (x != 0 || y != 0)  // a flow of zero has no angle
            flows.push_back({grid.place(piece.surface, piece.at), x, y});
    }
    sort_by_angle(flows);
    return flows;
}

}  // namespace endmill
