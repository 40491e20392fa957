// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// z = 40 a b (a^2 - b^2) / (a^2 + b^2 + 1/4) with a = x / 40, b = y / 40 over [-60, 60] by
/// [-40, 40] mm in cells by cells cells of two triangles.
inline TriangleMesh saddle_mesh(std::int32_t cells)
{
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    for (std::int32_t j = 0; j <= cells; ++j)
        for (std::int32_t i = 0; i <= cells; ++i) {
            const double a = (-60 + 120.0 * i / cells) / 40;
            const double b = (-40 + 80.0 * j / cells) / 40;
            points.emplace_back(40 * a, 40 * b,
                                40 * a * b * (a * a - b * b) / (a * a + b * b + 0.25));
        }
    for (std::int32_t j = 0; j < cells; ++j)
        for (std::int32_t i = 0; i < cells; ++i) {
            const std::int32_t low = j * (cells + 1) + i;
            const std::int32_t high = low + cells + 1;
            triangles.push_back({low, low + 1, high + 1});
            triangles.push_back({low, high + 1, high});
        }
    return {std::move(points), std::move(triangles)};
}

}  // namespace endmill
