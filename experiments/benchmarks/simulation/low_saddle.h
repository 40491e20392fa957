// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/path/tool_path.h"
#include "endmill/stock/height_stock.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// z = 20 a b (a^2 - b^2) / (a^2 + b^2 + 1/4) with a = x / 40, b = y / 40 over [-60, 60]
/// by [-40, 40] mm: a saddle of three valleys, no steeper than 34.3 degrees.
struct LowSaddle {
    static constexpr double half_length = 60;  ///< mm, along x
    static constexpr double half_width = 40;   ///< mm, along y

    /// Height in mm over (x, y) in mm.
    static double height(double x, double y)
    {
        const double a = x / 40;
        const double b = y / 40;
        return 20 * a * b * (a * a - b * b) / (a * a + b * b + 0.25);
    }

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
        return {{-half_length, -half_width, lowest}, {half_length, half_width, 20}};
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

/// Lines along x, forwards and backwards, at equal distances in y, in equal steps. The
/// cutter touches the saddle at every point.
inline ToolPath saddle_path(const Cutter& cutter, int lines, int steps)
{
    ToolPath path;
    path.points.reserve(static_cast<std::size_t>(lines) * (steps + 1));
    for (int line = 0; line < lines; ++line)
        for (int step = 0; step <= steps; ++step) {
            const int from_left = line % 2 == 0 ? step : steps - step;
            const double x = LowSaddle::half_length * (2.0 * from_left / steps - 1);
            const double y = LowSaddle::half_width * ((2.0 * line + 1) / lines - 1);
            const Vec3 normal = LowSaddle::normal(x, y);
            const Vec3 level{normal.x(), normal.y(), 0};
            // From the contact to the centre of the corner circle, to the axis, to the
            // tip.
            Vec3 tip = Vec3{x, y, LowSaddle::height(x, y)} +
                       cutter.corner_radius() * normal -
                       cutter.corner_radius() * Vec3::UnitZ();
            if (level.norm() > 0)
                tip += cutter.flat_radius() * level.normalized();
            path.points.push_back({.pass = line,
                                   .point = step,
                                   .move = step == 0 ? Move::Link : Move::Cut,
                                   .location = {tip, Vec3::UnitZ()},
                                   .contact = {},
                                   .patch = 0});
        }
    return path;
}

}  // namespace endmill
