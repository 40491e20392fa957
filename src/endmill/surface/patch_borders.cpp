// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/patch_borders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/core/error.h"

namespace endmill {
namespace {

constexpr int samples_per_side = 17;
constexpr int search_samples = 32;       // of a side, where the nearest point is sought
constexpr int refinements = 60;          // by golden section, to rounding
constexpr double same_end_share = 1e-6;  // of the part's size

// A side of a patch on the border of its surface.
struct Side {
    std::size_t number;  // of its surface
    const Surface* surface;
    SurfacePoint from;
    SurfacePoint to;
    std::array<Vec3, 2> ends;  // mm

    SurfacePoint at(double t) const
    {
        return {std::lerp(from.u, to.u, t), std::lerp(from.v, to.v, t)};
    }

    SurfaceTangents tangents(double t) const
    {
        const SurfacePoint place = at(t);
        return surface->tangents(place.u, place.v);
    }
};

Side side_between(std::size_t number, const Surface& surface, SurfacePoint from,
                  SurfacePoint to)
{
    return {number,
            &surface,
            from,
            to,
            {surface.tangents(from.u, from.v).point, surface.tangents(to.u, to.v).point}};
}

// Sides that are one point are left out.
void add_sides(std::size_t number, const Surface& surface, double same_end,
               std::vector<Side>& sides)
{
    const auto u = surface.breaks(Parameter::U);
    const auto v = surface.breaks(Parameter::V);
    const auto add = [&](SurfacePoint from, SurfacePoint to) {
        Side side = side_between(number, surface, from, to);
        double length = 0;
        for (const double t : {0.25, 0.5, 0.75, 1.0})
            length =
                std::max(length, (side.tangents(t).point - side.ends.front()).norm());
        if (length > same_end)
            sides.push_back(side);
    };
    for (const double edge : {v.front(), v.back()})
        for (std::size_t i = 0; i + 1 < u.size(); ++i)
            add({u[i], edge}, {u[i + 1], edge});
    for (const double edge : {u.front(), u.back()})
        for (std::size_t j = 0; j + 1 < v.size(); ++j)
            add({edge, v[j]}, {edge, v[j + 1]});
}

// Parameter of the point of `side` nearest to `point`.
double nearest_parameter(const Side& side, const Vec3& point)
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

bool meet(const Side& one, const Side& other, double same_end)
{
    const auto are_same = [&](int a, int b) {
        return (one.ends[a] - other.ends[b]).norm() <= same_end;
    };
    return (are_same(0, 0) && are_same(1, 1)) || (are_same(0, 1) && are_same(1, 0));
}

BorderBreak break_between(const Side& one, const Side& other, double size)
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

std::vector<Side> sides_of(std::span<const Surface> surfaces, double same_end)
{
    std::vector<Side> sides;
    for (std::size_t number = 0; number < surfaces.size(); ++number)
        add_sides(number, surfaces[number], same_end, sides);
    // Sides that meet have one middle of their ends: in this order they are neighbours.
    std::ranges::stable_sort(
        sides, {}, [](const Side& side) { return side.ends[0].x() + side.ends[1].x(); });
    return sides;
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
    if (surfaces.size() > 1) {
        const double same_end = same_end_share * size;
        const std::vector<Side> sides = sides_of(surfaces, same_end);
        const auto middle = [](const Side& side) {
            return side.ends[0].x() + side.ends[1].x();
        };
        for (auto one = sides.begin(); one != sides.end(); ++one)
            for (auto other = one + 1;
                 other != sides.end() && middle(*other) <= middle(*one) + 4 * same_end;
                 ++other)
                if (meet(*one, *other, same_end))
                    if (const BorderBreak border = break_between(*one, *other, size);
                        is_worse(border, whole.worst))
                        whole.worst = border;
    }
    whole.continuity = whole.worst.continuity;
    return whole;
}

}  // namespace endmill
