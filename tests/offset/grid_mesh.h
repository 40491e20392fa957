// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"
#include "endmill/offset/section_curve.h"

namespace endmill::test {

/// A grid of `columns` by `rows` points `point(i, j)`; each cell has the triangles a b d
/// and a d c.
template <class Point>
TriangleMesh grid_mesh(int columns, int rows, const Point& point)
{
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            points.push_back(point(i, j));
            if (i == 0 || j == 0)
                continue;
            const int d = j * columns + i;
            triangles.push_back({d - columns - 1, d - columns, d});
            triangles.push_back({d - columns - 1, d, d - 1});
        }
    return {std::move(points), std::move(triangles)};
}

/// A closed torus about the z axis; the radius of its tube is half that of its ring.
inline TriangleMesh torus_mesh(double ring, int around, int tube)
{
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    for (int j = 0; j < tube; ++j)
        for (int i = 0; i < around; ++i) {
            const double a = 2 * std::numbers::pi * (i + 0.3) / around;
            const double b = 2 * std::numbers::pi * (j + 0.2) / tube;
            const double far = ring * (1 + std::cos(b) / 2);
            points.emplace_back(far * std::cos(a), far * std::sin(a),
                                ring / 2 * std::sin(b));
            const int next_i = (i + 1) % around;
            const int next_j = (j + 1) % tube;
            const int corner = j * around + i;
            const int opposite = next_j * around + next_i;
            triangles.push_back({corner, j * around + next_i, opposite});
            triangles.push_back({corner, opposite, next_j * around + i});
        }
    return {std::move(points), std::move(triangles)};
}

/// The reference point of a ball of radius R on the graph of a function with the given
/// slopes.
inline Vec3 offset_of_graph(const Vec3& point, double slope_x, double slope_y, double R)
{
    const double w = std::sqrt(1 + slope_x * slope_x + slope_y * slope_y);
    return point + R / w * Vec3{-slope_x, -slope_y, 1};
}

/// Number of reversals of s along a curve, plus one; segments of constant s do not count.
inline int runs_of_s(const SectionCurve& curve)
{
    int runs = 0;
    double last = 0;
    for (std::size_t k = 1; k < curve.points.size(); ++k) {
        const double step = curve.points[k].x() - curve.points[k - 1].x();
        if (step == 0)
            continue;
        runs += last * step <= 0 ? 1 : 0;
        last = step;
    }
    return runs;
}

/// The crossings of segments of a curve that are not neighbours, by testing every pair.
inline std::vector<SectionPoint> crossings(const SectionCurve& curve)
{
    struct Segment {
        double x, y, dx, dy;
    };
    std::vector<Segment> segments;
    for (std::size_t k = 1; k < curve.points.size(); ++k) {
        const double x = curve.points[k - 1].x();
        const double y = curve.points[k - 1].y();
        segments.push_back({x, y, curve.points[k].x() - x, curve.points[k].y() - y});
    }
    std::vector<SectionPoint> found;
    for (std::size_t i = 0; i < segments.size(); ++i)
        for (std::size_t k = i + 2; k < segments.size(); ++k) {
            const Segment& one = segments[i];
            const Segment& two = segments[k];
            const double area = one.dx * two.dy - two.dx * one.dy;
            const double off_x = two.x - one.x;
            const double off_y = two.y - one.y;
            const double at = (off_x * two.dy - two.dx * off_y) / area;
            const double on = (off_x * one.dy - one.dx * off_y) / area;
            if (area != 0 && 0 < at && at < 1 && 0 < on && on < 1)
                found.emplace_back(one.x + at * one.dx, one.y + at * one.dy);
        }
    return found;
}

}  // namespace endmill::test
