// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// A rectangle of 120 by 80 mm about the origin.
struct GridPart {
    static constexpr double half_length = 60;  ///< mm, along x
    static constexpr double half_width = 40;   ///< mm, along y
};

/// A saddle of three valleys, mm.
inline double saddle_height(double x, double y)
{
    const double a = x / 40;
    const double b = y / 40;
    return 40 * a * b * (a * a - b * b) / (a * a + b * b + 0.25);
}

/// Bumps of two wave lengths, mm.
inline double bumpy_height(double x, double y)
{
    constexpr double turn = 2 * std::numbers::pi;
    return 4 * std::sin(turn * x / 30) * std::cos(turn * y / 25) +
           1.5 * std::sin(turn * (x + 0.7 * y) / 13) + 0.02 * x;
}

/// Heights over a grid of n by n cells, two triangles each.
template <typename Height>
TriangleMesh grid_part(int n, const Height& height)
{
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    points.reserve(static_cast<std::size_t>(n + 1) * (n + 1));
    triangles.reserve(2 * static_cast<std::size_t>(n) * n);
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const double x = GridPart::half_length * (2.0 * i / n - 1);
            const double y = GridPart::half_width * (2.0 * j / n - 1);
            points.emplace_back(x, y, height(x, y));
        }
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int a = j * (n + 1) + i;
            const int d = a + n + 2;
            triangles.push_back({a, a + 1, d});
            triangles.push_back({a, d, d - 1});
        }
    return {std::move(points), std::move(triangles)};
}

/// Lines along x, forwards and backwards, at equal distances in y.
inline std::vector<Eigen::Vector2d> zigzag_path(int lines, int steps)
{
    std::vector<Eigen::Vector2d> path;
    for (int line = 0; line < lines; ++line)
        for (int step = 0; step <= steps; ++step) {
            const int from_left = line % 2 == 0 ? step : steps - step;
            path.emplace_back(GridPart::half_length * (2.0 * from_left / steps - 1),
                              GridPart::half_width * ((2.0 * line + 1) / lines - 1));
        }
    return path;
}

}  // namespace endmill
