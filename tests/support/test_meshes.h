// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"
#include "random.h"

// Meshes with known geometry.
namespace endmill::test {

using Corners = std::array<Vec3, 3>;

/// The triangles of a mesh, each with its own points.
inline std::vector<Corners> soup_of(const TriangleMesh& mesh)
{
    std::vector<Corners> soup;
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k)
        soup.push_back(mesh.corners(k));
    return soup;
}

inline std::vector<Vec3> points_of(const TriangleMesh& mesh)
{
    return {mesh.points().begin(), mesh.points().end()};
}

inline std::vector<Triangle> triangles_of(const TriangleMesh& mesh)
{
    return {mesh.triangles().begin(), mesh.triangles().end()};
}

/// A grid of `columns` by `rows` cells of two triangles over the points `at(i, j)`, with
/// i from 0 to columns and j from 0 to rows. Seen from above it is counter-clockwise if i
/// runs along x and j along y.
template <typename At>
TriangleMesh grid_mesh(int columns, int rows, const At& at)
{
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i)
            points.push_back(at(i, j));
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const int corner = j * (columns + 1) + i;
            const int above = corner + columns + 1;
            triangles.push_back({corner, corner + 1, above + 1});
            triangles.push_back({corner, above + 1, above});
        }
    return {std::move(points), std::move(triangles)};
}

/// A plane grid of unit cells at z = 0.
inline TriangleMesh flat_mesh(int columns, int rows)
{
    return grid_mesh(columns, rows, [](int i, int j) {
        return Vec3{double(i), double(j), 0};
    });
}

/// The closed box between two corners, with normals outwards.
inline TriangleMesh box_mesh(const Vec3& low, const Vec3& high)
{
    std::vector<Vec3> points;
    for (int k = 0; k < 8; ++k)
        points.emplace_back((k & 1 ? high : low).x(), (k & 2 ? high : low).y(),
                            (k & 4 ? high : low).z());
    return {std::move(points),
            {{0, 2, 3},
             {0, 3, 1},
             {4, 5, 7},
             {4, 7, 6},
             {0, 1, 5},
             {0, 5, 4},
             {2, 6, 7},
             {2, 7, 3},
             {0, 4, 6},
             {0, 6, 2},
             {1, 3, 7},
             {1, 7, 5}}};
}

/// A closed torus around z of `around` by `across` quadrangles, each made of two
/// triangles, with normals outwards.
inline TriangleMesh torus_mesh(int around, int across, double radius = 3, double tube = 1)
{
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    const auto number = [&](int i, int j) { return i % around * across + j % across; };
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            const double u = 2 * std::numbers::pi * i / around;
            const double v = 2 * std::numbers::pi * j / across;
            const double out = radius + tube * std::cos(v);
            points.emplace_back(out * std::cos(u), out * std::sin(u), tube * std::sin(v));
            triangles.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1)});
            triangles.push_back({number(i, j), number(i + 1, j + 1), number(i, j + 1)});
        }
    return {std::move(points), std::move(triangles)};
}

/// All triangles of both meshes; the points of the second follow those of the first.
inline TriangleMesh both(const TriangleMesh& a, const TriangleMesh& b)
{
    std::vector<Vec3> points = points_of(a);
    std::vector<Triangle> triangles = triangles_of(a);
    const auto shift = static_cast<std::int32_t>(points.size());
    points.insert(points.end(), b.points().begin(), b.points().end());
    for (const auto& [p, q, r] : b.triangles())
        triangles.push_back({p + shift, q + shift, r + shift});
    return {std::move(points), std::move(triangles)};
}

/// The mesh with those triangles turned over for which `choose(number)` is true.
template <typename Choose>
TriangleMesh with_turned(const TriangleMesh& mesh, const Choose& choose)
{
    std::vector<Triangle> triangles = triangles_of(mesh);
    for (std::size_t k = 0; k < triangles.size(); ++k)
        if (choose(k))
            std::swap(triangles[k][1], triangles[k][2]);
    return {points_of(mesh), std::move(triangles)};
}

/// A random point in the cube of half side `size` around the origin.
inline Vec3 random_point(Random& random, double size)
{
    const double x = random.uniform(-size, size);
    const double y = random.uniform(-size, size);
    return {x, y, random.uniform(-size, size)};
}

}  // namespace endmill::test
