// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/polygon_fan.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

// A fan joins one corner of the polygon, its hub, to all edges that do not touch it.
//
// 1. The mean normal of the polygon is half its vector area; it does not depend on the
//    order of summation and is defined for polygons that are not planar.
// 2. For a hub, every triangle of the fan is compared with the mean normal: a triangle
//    with a negative component along it would fold the surface over.
// 3. Hubs are tried in the order of corners. A hub that gives triangles without area is
//    used only if no other qualifies; such triangles are left out later.

namespace endmill {
namespace {

// Bounds the time for a polygon of n corners to 100 n triangles.
constexpr std::size_t most_corners_tried = 100;

// Twice the vector area of the polygon.
Vec3 mean_normal(std::span<const Vec3> polygon)
{
    Vec3 normal = Vec3::Zero();
    const Vec3& first = polygon.front();
    for (std::size_t i = 2; i < polygon.size(); ++i)
        normal += (polygon[i - 1] - first).cross(polygon[i] - first);
    return normal;
}

// Quality of a fan: all triangles have an area; some have none; some are reversed.
enum class Fan { Sound, WithoutAreaInPlaces, Folded };

// The quality of the fan from corner `start`. Areas are compared by their component along
// the mean normal, so the polygon need not be planar.
Fan fan_from(std::size_t start, std::span<const Vec3> polygon, const Vec3& normal)
{
    const std::size_t corners = polygon.size();
    const Vec3& hub = polygon[start];
    Fan fan = Fan::Sound;
    for (std::size_t i = 2; i < corners; ++i) {
        const Vec3& a = polygon[(start + i - 1) % corners];
        const Vec3& b = polygon[(start + i) % corners];
        const Vec3 area = (a - hub).cross(b - hub);
        if (area.dot(normal) > 0)
            continue;
        if (!area.isZero(0))
            return Fan::Folded;
        fan = Fan::WithoutAreaInPlaces;
    }
    return fan;
}

}  // namespace

std::optional<std::size_t> fan_corner(std::span<const Vec3> polygon)
{
    const Vec3 normal = mean_normal(polygon);
    std::optional<std::size_t> second_choice;
    for (std::size_t i = 0; i < std::min(polygon.size(), most_corners_tried); ++i) {
        const Fan fan = fan_from(i, polygon, normal);
        if (fan == Fan::Sound)
            return i;
        if (fan == Fan::WithoutAreaInPlaces && !second_choice)
            second_choice = i;
    }
    return second_choice;
}

double out_of_plane(std::span<const Vec3> polygon)
{
    const Vec3 normal = mean_normal(polygon).stableNormalized();
    Vec3 mean = Vec3::Zero();
    for (const Vec3& corner : polygon)
        mean += corner / static_cast<double>(polygon.size());
    double farthest = 0;
    for (const Vec3& corner : polygon)
        farthest = std::max(farthest, std::abs((corner - mean).dot(normal)));
    return farthest;
}

}  // namespace endmill
