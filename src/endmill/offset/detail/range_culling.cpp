// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/offset/detail/range_culling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace endmill {
namespace {

constexpr std::size_t triangles_a_cell = 2;

std::vector<Interval> empty_ranges(std::size_t count)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return std::vector<Interval>(count, Interval{infinity, -infinity});
}

void extend(Interval& range, double t)
{
    range.low = std::min(range.low, t);
    range.high = std::max(range.high, t);
}

}  // namespace

std::size_t culled_pairs(std::span<const Interval> ranges, std::span<const double> planes)
{
    std::size_t count = 0;
    for (const Interval& range : ranges)
        for (const double c : planes)
            count += range.low <= c && c < range.high ? 1 : 0;
    return count;
}

std::vector<Interval> cell_ranges(const OffsetMesh& offset, const DriveFrame& frame)
{
    const TriangleMesh& mesh = offset.mesh;
    auto ranges = empty_ranges(mesh.triangles().size() / triangles_a_cell);
    for (std::size_t i = 0; i < mesh.triangles().size(); ++i)
        for (const Vec3& corner : mesh.corners(i))
            extend(ranges[i / triangles_a_cell], frame.across(corner));
    return ranges;
}

std::vector<Interval> strip_ranges(const OffsetMesh& offset, const DriveFrame& frame,
                                   int grid_lines)
{
    const auto strips = static_cast<std::size_t>(grid_lines) - 1;
    auto ranges = empty_ranges(strips);
    for (std::size_t vertex = 0; vertex < offset.mesh.points().size(); ++vertex) {
        const double u = offset.contacts[vertex].at.u;
        const auto line =
            static_cast<std::size_t>(std::lround(u * static_cast<double>(strips)));
        const double t = frame.across(offset.mesh.points()[vertex]);
        if (line > 0)
            extend(ranges[line - 1], t);
        if (line < strips)
            extend(ranges[line], t);
    }
    return ranges;
}

}  // namespace endmill
