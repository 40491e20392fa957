// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/iso_cuts.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace endmill {

void for_each_iso_cut(std::span<const Surface> surfaces, const ToolPath& path,
                      Parameter along, const std::function<void(const IsoCut&)>& visit)
{
    // All passes run along u on these.
    std::vector<Surface> turned;
    for (const Surface& surface : surfaces)
        turned.push_back(along == Parameter::U ? surface : transposed(surface));
    const auto parameters = [&](const PathPoint& point) {
        const auto& [u, v, contact] = *point.contact();
        return along == Parameter::U ? SurfacePoint{u, v} : SurfacePoint{v, u};
    };
    // The line of a pass is kept for all its moves, because it costs more to construct
    // than a move to measure. A new one is needed if the constant parameter or the patch
    // changes.
    std::optional<IsoLine> line;
    int patch_of_line = 0;
    for (std::size_t k = 1; k < path.points.size(); ++k) {
        const PathPoint& start = path.points[k - 1];
        const PathPoint& end = path.points[k];
        if (end.move != Move::Cut)
            continue;
        const Surface& surface = turned[static_cast<std::size_t>(start.patch)];
        const SurfacePoint from = parameters(start);
        if (!line || line->v() != from.v || patch_of_line != start.patch)
            line.emplace(surface, from.v);
        patch_of_line = start.patch;
        visit({surface, *line, from.u, parameters(end).u, start, end});
    }
}

}  // namespace endmill
