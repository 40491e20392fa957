// SPDX-License-Identifier: GPL-3.0-or-later
#include "five-axis-setup/savings/necked_recess.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace endmill {

TriangleMesh necked_recess()
{
    constexpr std::int32_t sides = 24;
    // Radius and height in mm, from the middle of the bottom to the middle of the floor.
    // The two ends on the axis stand for one point each.
    constexpr std::array<std::array<double, 2>, 8> profile{
        {{0, 0}, {30, 0}, {30, 40}, {5, 40}, {5, 30}, {20, 30}, {20, 10}, {0, 10}}};
    std::vector<Vec3> points;
    for (const auto& [radius, height] : profile)
        for (std::int32_t k = 0; k < sides; ++k) {
            const double azimuth = 2 * std::numbers::pi * k / sides;
            points.emplace_back(radius * std::cos(azimuth), radius * std::sin(azimuth),
                                height);
        }
    std::vector<Triangle> triangles;
    for (std::int32_t ring = 0; ring + 1 < std::ssize(profile); ++ring)
        for (std::int32_t k = 0; k < sides; ++k) {
            const std::int32_t a = ring * sides + k;
            const std::int32_t b = ring * sides + (k + 1) % sides;
            if (ring > 0)  // the first ring is a point
                triangles.push_back({a, b, b + sides});
            if (ring + 2 < std::ssize(profile))  // the last ring is a point
                triangles.push_back({a, b + sides, a + sides});
        }
    return {std::move(points), std::move(triangles)};
}

}  // namespace endmill
