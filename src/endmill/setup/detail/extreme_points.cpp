// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/extreme_points.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_3.h>

namespace endmill {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// Points of which the hull is not computed.
constexpr std::size_t few_points = 16;

}  // namespace

std::vector<Vec3> extreme_points(std::vector<Vec3> points)
{
    if (points.size() <= few_points)
        return points;
    std::vector<Kernel::Point_3> all;
    all.reserve(points.size());
    for (const Vec3& point : points)
        all.emplace_back(point.x(), point.y(), point.z());
    std::vector<Kernel::Point_3> extreme;
    CGAL::extreme_points_3(all, std::back_inserter(extreme));
    // CGAL 5.5 returns other points than the ends of a line. These are the first and the
    // last in lexicographical order.
    if (extreme.size() <= 2) {
        const auto [first, last] = std::ranges::minmax_element(all);
        extreme = {*first, *last};
    }
    points.clear();
    for (const Kernel::Point_3& point : extreme)
        points.emplace_back(point.x(), point.y(), point.z());
    return points;
}

}  // namespace endmill
