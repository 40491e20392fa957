// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/patch_borders.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/surface/patch_sides.h"

namespace endmill {
namespace {

constexpr int samples_per_side = 17;
constexpr int search_samples = 32;  // of a side, where the nearest point is sought
constexpr int refinements = 60;     // by golden section, to rounding

// Parameter of the point of `side` nearest to `point`.
double nearest_parameter(const PatchSide& side, const Vec3& point)
{
    const auto distance = [&](double t) {
        return (side.tangents(t).point - point).squaredNorm();
    };
    int nearest = 0;
    double least = distance(0);
    for (int k = 1; k <= search_samples; ++k)
        if (const double d = distance(k / double(search_samples)); d < least) {
            least = d;
            nearest = k;
        }
    constexpr double golden = std::numbers::phi - 1;
    double low = std::max(nearest - 1, 0) / double(search_samples);
    double high = std::min(nearest + 1, search_samples) / double(search_samples);
    for (int k = 0; k < refinements; ++k) {
        const double width = golden * (high - low);
        if (distance(high - width) < distance(low + width))
            high = low + width;
        else
            low = high - width;
    }
    // Newton's last step: the distance itself is flat to half its digits.
    const double t = std::midpoint(low, high);
    const SurfaceTangents at = side.tangents(t);
    const Vec3 along =
        at.du * (side.to.u - side.from.u) + at.dv * (side.to.v - side.from.v);
    const double speed2 = along.squaredNorm();
    const double step = speed2 > 0 ? (point - at.point).dot(along) / speed2 : 0;
    return std::clamp(t + step, 0.0, 1.0);
}

// The angle between the planes, whichever way the normals point.
double plane_angle(const SurfaceTangents& one, const SurfaceTangents& other)
{
    if (is_singular(one) || is_singular(other))
        return 0;
    const Vec3 n = unit_normal(one);
    const Vec3 m = unit_normal(other);
    return std::atan2(n.cross(m).norm(), std::abs(n.dot(m)));
}

BorderBreak break_between(const PatchSide& one, const PatchSide& other, double size)
{
    BorderBreak worst{one.from, {}, Angle::radians(-1), 0, Continuity::G1, one.number};
    for (int sample = 0; sample < samples_per_side; ++sample) {
        const double t = sample / double(samples_per_side - 1);
        const SurfaceTangents here = one.tangents(t);
        const SurfaceTangents there =
            other.tangents(nearest_parameter(other, here.point));
        worst.gap_mm = std::max(worst.gap_mm, (here.point - there.point).norm());
        const Angle angle = Angle::radians(plane_angle(here, there));
        if (angle.radians() > worst.normals.radians()) {
            worst.at = one.at(t);
            worst.point = here.point;
            worst.normals = angle;
        }
    }
    worst.continuity = continuity_of(worst.gap_mm, worst.normals, size);
    return worst;
}

}  // namespace

SurfaceContinuity continuity(std::span<const Surface> surfaces)
{
    require(!surfaces.empty(), "continuity: need a surface");
    SurfaceContinuity whole = continuity(surfaces.front());
    double size = 0;
    for (std::size_t number = 0; number < surfaces.size(); ++number) {
        BorderBreak own = continuity(surfaces[number]).worst;
        own.surface = number;
        if (is_worse(own, whole.worst))
            whole.worst = own;
        size = std::max(size, surfaces[number].diagonal());
    }
    const std::vector<PatchSide> sides = patch_sides(surfaces);
    for (const auto& [one, other] : meeting_sides(sides, same_end_mm(surfaces)))
        if (const BorderBreak border = break_between(sides[one], sides[other], size);
            is_worse(border, whole.worst))
            whole.worst = border;
    whole.continuity = whole.worst.continuity;
    return whole;
}

}  // namespace endmill
