// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/plane_offset.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "endmill/core/tolerance.h"
#include "endmill/cutter/cutter.h"

namespace endmill {
namespace {

// Sign of n_x; 0 where the tangent is level.
int side_of(const ProfilePoint& at)
{
    if (std::abs(at.normal.x()) <= level_normal)
        return 0;
    return at.normal.x() > 0 ? 1 : -1;
}

// The sign at the first point that has one; 0 if all points are level.
int next_side(std::span<const ProfilePoint> from)
{
    const auto found = std::ranges::find_if(
        from, [](const ProfilePoint& at) { return side_of(at) != 0; });
    return found == from.end() ? 0 : side_of(*found);
}

}  // namespace

Eigen::Vector2d profile_normal(double slope)
{
    return Eigen::Vector2d{-slope, 1} / std::hypot(1, slope);
}

Eigen::Vector2d crease_normal(double slope_before, double slope_behind)
{
    return profile_normal(std::midpoint(slope_before, slope_behind));
}

Eigen::Vector2d curve_normal(const Eigen::Vector2d& tangent)
{
    const Eigen::Vector2d left =
        Eigen::Vector2d{-tangent.y(), tangent.x()}.stableNormalized();
    return left.y() < 0 ? Eigen::Vector2d{-left} : left;
}

std::vector<Eigen::Vector2d> plane_offset(const Cutter& cutter,
                                          std::span<const ProfilePoint> profile)
{
    std::vector<Eigen::Vector2d> points;
    points.reserve(profile.size());
    int side = next_side(profile);
    for (std::size_t k = 0; k < profile.size(); ++k) {
        const auto add = [&](int towards) {
            points.push_back(profile[k].point +
                             cutter.corner_radius() * profile[k].normal +
                             Eigen::Vector2d{towards * cutter.flat_radius(), 0});
        };
        add(side);
        // A level part keeps the sign before it up to its last point.
        const bool ends_level = side_of(profile[k]) == 0 && k + 1 < profile.size() &&
                                side_of(profile[k + 1]) != 0;
        const int behind = side_of(profile[ends_level ? k + 1 : k]);
        if (behind == 0 || behind == side)
            continue;
        side = behind;
        if (!cutter.is_ball())
            add(side);
    }
    return points;
}

}  // namespace endmill
