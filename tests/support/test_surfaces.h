// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "endmill/surface/surface.h"
#include "random.h"

// Surfaces with closed-form geometry.
namespace endmill::test {

/// A polynomial, the sum of c(m, n) x^m y^n, cubic in x and y, given by its coefficients.
using Polynomial = Eigen::Matrix4d;

/// One term `c` x^m y^n.
inline Polynomial monomial(int m, int n, double c)
{
    Polynomial polynomial = Polynomial::Zero();
    polynomial(m, n) = c;
    return polynomial;
}

/// A rectangle in the xy plane.
struct Rectangle {
    Interval x;
    Interval y;
};

/// Numbers of patches along u and along v.
struct PatchCounts {
    int u;
    int v;
};

/// The blossoms of 1, t, t^2 and t^3, taken as cubics, at (a, ..., a, b, ..., b) with
/// `upper` times b: the Bernstein coefficients of the powers on [a, b].
inline Eigen::Vector4d power_blossoms(Interval over, int upper)
{
    std::array<double, 3> t;
    for (int k = 0; k < 3; ++k)
        t[k] = k < upper ? over.high : over.low;
    return {1, (t[0] + t[1] + t[2]) / 3, (t[0] * t[1] + t[0] * t[2] + t[1] * t[2]) / 3,
            t[0] * t[1] * t[2]};
}

/// Part number `k` of `parts` equal parts of `whole`.
inline Interval part_of(Interval whole, int k, int parts)
{
    return {std::lerp(whole.low, whole.high, k / double(parts)),
            std::lerp(whole.low, whole.high, (k + 1) / double(parts))};
}

/// Control points, u varying fastest, of the composite net of a polynomial in x and y
/// with values in space; u runs along x and v along y.
inline std::vector<Vec3> polynomial_net(const std::array<Polynomial, 3>& space,
                                        const Rectangle& over, PatchCounts patches)
{
    std::vector<Vec3> net;
    for (int row = 0; row <= 3 * patches.v; ++row)
        for (int column = 0; column <= 3 * patches.u; ++column) {
            const int i = std::min(column / 3, patches.u - 1);
            const int j = std::min(row / 3, patches.v - 1);
            const auto x = power_blossoms(part_of(over.x, i, patches.u), column - 3 * i);
            const auto y = power_blossoms(part_of(over.y, j, patches.v), row - 3 * j);
            net.emplace_back(x.dot(space[0] * y), x.dot(space[1] * y),
                             x.dot(space[2] * y));
        }
    return net;
}

/// The surface of `polynomial_net`.
inline Surface polynomial_surface(const std::array<Polynomial, 3>& space,
                                  const Rectangle& over, PatchCounts patches = {1, 1},
                                  ToolSide side = ToolSide::Up)
{
    return composite_bezier(patches.u, patches.v, polynomial_net(space, over, patches),
                            side);
}

/// The surface z = height(x, y) over a rectangle; u runs along x and v along y.
inline Surface graph(const Polynomial& height, const Rectangle& over,
                     PatchCounts patches = {1, 1})
{
    return polynomial_surface({monomial(1, 0, 1), monomial(0, 1, 1), height}, over,
                              patches);
}

/// The flat parallelogram with a corner at the origin and the sides `along_u` and
/// `along_v`.
inline Surface parallelogram(const Vec3& along_u, const Vec3& along_v,
                             PatchCounts patches = {1, 1})
{
    std::array<Polynomial, 3> space;
    for (int c = 0; c < 3; ++c)
        space[c] = monomial(1, 0, along_u[c]) + monomial(0, 1, along_v[c]);
    return polynomial_surface(space, {{0, 1}, {0, 1}}, patches);
}

/// The plane z = 0 over 0 to size_x by 0 to size_y.
inline Surface plane(double size_x, double size_y, PatchCounts patches = {1, 1})
{
    return parallelogram({size_x, 0, 0}, {0, size_y, 0}, patches);
}

/// The saddle z = (x^2 - y^2) / (2 c) over |x|, |y| <= half.
inline Surface saddle(double c, double half, PatchCounts patches = {1, 1})
{
    return graph(monomial(2, 0, 0.5 / c) + monomial(0, 2, -0.5 / c),
                 {{-half, half}, {-half, half}}, patches);
}

/// The surface z = bend x^2 / 2 over -half_x to half_x by 0 to size_y: a trough if bend >
/// 0.
inline Surface parabolic_cylinder(double bend, double half_x, double size_y,
                                  PatchCounts patches = {1, 1})
{
    return graph(monomial(2, 0, bend / 2), {{-half_x, half_x}, {0, size_y}}, patches);
}

/// Two planes with slopes -slope and +slope that meet along x = 0, in 2 by 1 patches.
inline Surface valley(double half_x, double size_y, double slope)
{
    std::vector<Vec3> net;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 7; ++column) {
            const double x = half_x * (column - 3) / 3;
            net.emplace_back(x, size_y * row / 3, slope * std::abs(x));
        }
    return composite_bezier(2, 1, net);
}

/// Random control points around a regular grid of spacing 10 mm, displaced by up to
/// `disorder` mm.
inline std::vector<Vec3> random_net(unsigned seed, PatchCounts patches, double disorder)
{
    Random random{seed};
    const auto off = [&] { return random.uniform(-disorder, disorder); };
    std::vector<Vec3> net;
    for (int row = 0; row <= 3 * patches.v; ++row)
        for (int column = 0; column <= 3 * patches.u; ++column) {
            const double x = 10 * column + off();
            const double y = 10 * row + off();
            net.emplace_back(x, y, off());
        }
    return net;
}

/// The surface of `random_net`.
inline Surface random_surface(unsigned seed, PatchCounts patches = {1, 1},
                              double disorder = 4)
{
    return composite_bezier(patches.u, patches.v, random_net(seed, patches, disorder));
}

}  // namespace endmill::test
