// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/path/tool_path.h"
#include "endmill/stock/height_stock.h"
#include "endmill/surface/surface.h"

// The parts of the benchmarks: heights over a rectangle as meshes and as a surface, and
// paths over them.
namespace endmill {

/// A rectangle of 120 by 80 mm about the origin.
struct GridPart {
    static constexpr double half_length = 60;  ///< mm, along x
    static constexpr double half_width = 40;   ///< mm, along y
};

/// A saddle of three valleys: z = 40 a b (a^2 - b^2) / (a^2 + b^2 + 1/4) with a = x / 40
/// and b = y / 40, all in mm.
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

/// Bumps 63 mm long and 31 mm wide, mm.
inline double wavy_height(double x, double y)
{
    return std::sin(0.1 * x) * std::cos(0.2 * y);
}

/// A mesh over `columns` by `rows` cells, two triangles each. \param point the vertex (i,
/// j), 0 <= i <= columns and 0 <= j <= rows.
template <typename Point>
TriangleMesh grid_mesh(std::int32_t columns, std::int32_t rows, const Point& point)
{
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    points.reserve(static_cast<std::size_t>(columns + 1) * (rows + 1));
    triangles.reserve(2 * static_cast<std::size_t>(columns) * rows);
    for (std::int32_t j = 0; j <= rows; ++j)
        for (std::int32_t i = 0; i <= columns; ++i)
            points.push_back(point(i, j));
    for (std::int32_t j = 0; j < rows; ++j)
        for (std::int32_t i = 0; i < columns; ++i) {
            const std::int32_t a = j * (columns + 1) + i;
            const std::int32_t d = a + columns + 2;
            triangles.push_back({a, a + 1, d});
            triangles.push_back({a, d, d - 1});
        }
    return {std::move(points), std::move(triangles)};
}

/// Heights over `GridPart` in n by n cells.
template <typename Height>
TriangleMesh grid_part(int n, const Height& height)
{
    return grid_mesh(n, n, [&](int i, int j) {
        const double x = GridPart::half_length * (2.0 * i / n - 1);
        const double y = GridPart::half_width * (2.0 * j / n - 1);
        return Vec3{x, y, height(x, y)};
    });
}

/// `wavy_height` with twice as many cells along x as along y.
inline TriangleMesh wavy_part(std::int32_t along, double cell_mm)
{
    return grid_mesh(along, along / 2, [=](int i, int j) {
        return Vec3{i * cell_mm, j * cell_mm, wavy_height(i * cell_mm, j * cell_mm)};
    });
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

/// Lines along x over `GridPart`, forwards and backwards, at equal distances in y.
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

/// Half of `saddle_height` over `GridPart`, no steeper than 34.3 degrees.
struct LowSaddle {
    /// Height in mm over (x, y) in mm.
    static double height(double x, double y) { return saddle_height(x, y) / 2; }

    /// Unit normal, upwards.
    static Vec3 normal(double x, double y)
    {
        const double a = x / 40;
        const double b = y / 40;
        const double over = a * a + b * b + 0.25;
        const double share = 2 * a * b * (a * a - b * b) / (over * over);
        const double slope_x = 0.5 * (b * (3 * a * a - b * b) / over - a * share);
        const double slope_y = 0.5 * (a * (a * a - 3 * b * b) / over - b * share);
        return Vec3{-slope_x, -slope_y, 1}.normalized();
    }

    /// The block that the saddle is cut from; its bottom is 1 mm below the saddle.
    static Block block()
    {
        constexpr double lowest =
            -13.4;  // the lowest points, at the ends of the valleys, are at -12.39
        return {{-GridPart::half_length, -GridPart::half_width, lowest},
                {GridPart::half_length, GridPart::half_width, 20}};
    }
};

/// Bernstein coefficient `i` of t^power as a cubic over [low, high]: its blossom at 3 - i
/// times `low` and i times `high`.
inline double cubic_coefficient(int i, int power, double low, double high)
{
    const auto t = [&](int k) { return k < 3 - i ? low : high; };
    switch (power) {
        case 0:
            return 1;
        case 1:
            return (t(0) + t(1) + t(2)) / 3;
        case 2:
            return (t(0) * t(1) + t(1) * t(2) + t(2) * t(0)) / 3;
        default:
            return t(0) * t(1) * t(2);
    }
}

/// The saddle as an exact surface: 2 by 2 rational bicubic patches, u along x and v along
/// y.
inline Surface low_saddle_surface()
{
    const std::vector<double> breaks_a{-1.5, 0, 1.5};
    const std::vector<double> breaks_b{-1, 0, 1};
    std::vector<BezierPatch> patches;
    for (std::size_t row = 0; row < 2; ++row)
        for (std::size_t column = 0; column < 2; ++column) {
            std::vector<Eigen::Vector4d> net;
            for (int j = 0; j < 4; ++j)
                for (int i = 0; i < 4; ++i) {
                    const auto term = [&](int m, int n) {  // a^m b^n
                        return cubic_coefficient(i, m, breaks_a[column],
                                                 breaks_a[column + 1]) *
                               cubic_coefficient(j, n, breaks_b[row], breaks_b[row + 1]);
                    };
                    net.emplace_back(40 * (term(3, 0) + term(1, 2) + term(1, 0) / 4),
                                     40 * (term(2, 1) + term(0, 3) + term(0, 1) / 4),
                                     20 * (term(3, 1) - term(1, 3)),
                                     term(2, 0) + term(0, 2) + 0.25);
                }
            patches.push_back(BezierPatch::from_homogeneous(3, 3, net, true));
        }
    return {breaks_a, breaks_b, std::move(patches)};
}

/// `zigzag_path` with a cutter that touches the low saddle at every point.
inline ToolPath saddle_path(const Cutter& cutter, int lines, int steps)
{
    ToolPath path;
    const auto places = zigzag_path(lines, steps);
    path.points.reserve(places.size());
    for (const Eigen::Vector2d& place : places) {
        const Vec3 contact{place.x(), place.y(), LowSaddle::height(place.x(), place.y())};
        const auto number = static_cast<int>(path.points.size());
        const int step = number % (steps + 1);
        path.points.push_back(
            {.pass = number / (steps + 1),
             .point = step,
             .move = step == 0 ? Move::Link : Move::Cut,
             .location = {
                 control_point(cutter, {contact, LowSaddle::normal(place.x(), place.y())},
                               ControlPoint::Tip),
                 Vec3::UnitZ()}});
    }
    return path;
}

}  // namespace endmill
