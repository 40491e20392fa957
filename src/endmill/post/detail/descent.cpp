// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/descent.h"

#include "endmill/post/program.h"

namespace endmill {
namespace {

// The last of the vertical plunges that begin with `first` and have its tool.
std::size_t last_plunge(const ToolPath& path, std::size_t first)
{
    const std::vector<PathPoint>& points = path.points;
    std::size_t last = first;
    const auto continues = [&](const PathPoint& next) {
        const Vec3& tip = points[last].location.tip;
        return next.move == Move::Plunge && next.location.tip.z() <= tip.z() &&
               next.location.tip.head<2>() == tip.head<2>() &&
               next.conditions.tool == points[first].conditions.tool;
    };
    while (last + 1 < points.size() && continues(points[last + 1]))
        ++last;
    return last;
}

}  // namespace

std::optional<Descent> descent_at(const ToolPath& path, std::size_t first,
                                  double start_height)
{
    if (!is_descent(path, first))
        return std::nullopt;
    const Vec3& tip = path.points[first].location.tip;
    Vec3 before = first > 0 ? path.points[first - 1].location.tip : tip;
    if (first == 0)
        before.z() = start_height;
    if (!(before.z() > tip.z()) || before.head<2>() != tip.head<2>())
        return std::nullopt;
    const std::size_t last = last_plunge(path, first);
    return Descent{first, last, before.z(), path.points[last].location.tip.z()};
}

bool leads_to_cut(const ToolPath& path, const Descent& descent)
{
    const std::size_t next = descent.last + 1;
    return next < path.points.size() && path.points[next].move == Move::Cut &&
           path.points[next].conditions.tool == path.points[descent.last].conditions.tool;
}

}  // namespace endmill
