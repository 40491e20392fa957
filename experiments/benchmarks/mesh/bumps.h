// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// Height in mm at (x, y) in mm: bumps 63 mm long and 31 mm wide.
inline double height(double x, double y)
{
    return std::sin(0.1 * x) * std::cos(0.2 * y);
}

/// A mesh with twice as many cells along x as along y, two triangles each.
inline TriangleMesh bumps(std::int32_t along, double cell_mm)
{
    const std::int32_t across = along / 2;
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    points.reserve(std::size_t(along + 1) * std::size_t(across + 1));
    triangles.reserve(std::size_t(along) * std::size_t(across) * 2);
    for (std::int32_t j = 0; j <= across; ++j)
        for (std::int32_t i = 0; i <= along; ++i)
            points.emplace_back(i * cell_mm, j * cell_mm,
                                height(i * cell_mm, j * cell_mm));
    for (std::int32_t j = 0; j < across; ++j)
        for (std::int32_t i = 0; i < along; ++i) {
            const std::int32_t low = j * (along + 1) + i;
            const std::int32_t high = low + along + 1;
            triangles.push_back({low, low + 1, high + 1});
            triangles.push_back({low, high + 1, high});
        }
    return {std::move(points), std::move(triangles)};
}

/// The triangles of a mesh, each with its own corners.
inline std::vector<std::array<Vec3, 3>> soup_of(const TriangleMesh& mesh)
{
    std::vector<std::array<Vec3, 3>> soup;
    soup.reserve(mesh.triangles().size());
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k)
        soup.push_back(mesh.corners(k));
    return soup;
}

}  // namespace endmill
