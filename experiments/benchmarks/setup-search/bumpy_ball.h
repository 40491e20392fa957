// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// A closed ball of radius 40 mm with bumps of 2 mm, cut along meridians and parallels.
/// \param meridians at least 3; there are half as many bands between the poles, so that
///        the mesh has meridians * (meridians - 2) facets.
inline TriangleMesh bumpy_ball(std::int32_t meridians)
{
    using std::numbers::pi;
    const std::int32_t bands = meridians / 2;
    auto point = [&](std::int32_t band, std::int32_t meridian) {
        const double polar = pi * band / bands;
        const double azimuth = 2 * pi * meridian / meridians;
        const double across = std::sin(polar);
        const double radius =
            40 + 2 * std::sin(9 * azimuth) * across * std::cos(7 * polar);
        return Vec3{radius * across * std::cos(azimuth),
                    radius * across * std::sin(azimuth), radius * std::cos(polar)};
    };
    std::vector<Vec3> points{point(0, 0)};
    for (std::int32_t band = 1; band < bands; ++band)
        for (std::int32_t k = 0; k < meridians; ++k)
            points.push_back(point(band, k));
    points.push_back(point(bands, 0));
    const auto last = static_cast<std::int32_t>(points.size()) - 1;
    std::vector<Triangle> triangles;
    for (std::int32_t k = 0; k < meridians; ++k) {
        const std::int32_t next = (k + 1) % meridians;
        triangles.push_back({0, 1 + k, 1 + next});
        for (std::int32_t band = 1; band + 1 < bands; ++band) {
            const std::int32_t upper = 1 + (band - 1) * meridians;
            const std::int32_t lower = upper + meridians;
            triangles.push_back({upper + k, lower + k, lower + next});
            triangles.push_back({upper + k, lower + next, upper + next});
        }
        const std::int32_t lowest = 1 + (bands - 2) * meridians;
        triangles.push_back({last, lowest + next, lowest + k});
    }
    return {std::move(points), std::move(triangles)};
}

}  // namespace endmill
