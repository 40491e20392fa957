// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/path_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "bound_surfaces.h"
#include "test_surfaces.h"

// Random paths that cover a part, laid and checked without the library, try to be shorter than
// the bound.
namespace endmill {
namespace {

constexpr double R = 7.5;
constexpr double h = 0.5;
constexpr double half = 20;  // of the part in x and y, mm

// z = (x^2 - y^2) / c; a plane for an infinite c.
struct Graph {
    double c;

    Vec3 point(double x, double y) const { return {x, y, (x * x - y * y) / c}; }
    Vec3 normal(double x, double y) const
    {
        return Vec3{-2 * x / c, 2 * y / c, 1}.normalized();
    }
};

struct Path {
    double length = 0;  // of the contacts, mm
    int pieces = 0;
    std::vector<Vec3> centres;
};

// Wavy passes at an angle, cut at the border of the part.
Path passes(const Graph& part, double angle, double pitch, double start, double wave)
{
    constexpr double step = 0.4;
    Path path;
    for (double t = -1.5 * half + start * pitch; t < 1.5 * half; t += pitch) {
        bool is_cutting = false;
        Vec3 last;
        for (double s = -1.5 * half; s < 1.5 * half; s += step) {
            const double across = t + wave * std::sin(s / 9);
            const double x = s * std::cos(angle) - across * std::sin(angle);
            const double y = s * std::sin(angle) + across * std::cos(angle);
            const bool is_on = std::abs(x) <= half && std::abs(y) <= half;
            if (is_on) {
                const Vec3 point = part.point(x, y);
                path.pieces += is_cutting ? 0 : 1;
                path.length += is_cutting ? (point - last).norm() : 0;
                path.centres.push_back(point + R * part.normal(x, y));
                last = point;
            }
            is_cutting = is_on;
        }
    }
    return path;
}

// Whether every sampled raised point is within R of the ball or of its flank.
bool is_covered(const Graph& part, const Path& path)
{
    constexpr int samples = 40;
    for (int i = 0; i <= samples; ++i)
        for (int j = 0; j <= samples; ++j) {
            const double x = half * (2.0 * i / samples - 1);
            const double y = half * (2.0 * j / samples - 1);
            const Vec3 raised = part.point(x, y) + h * part.normal(x, y);
            bool is_reached = false;
            for (const Vec3& centre : path.centres) {
                Vec3 away = raised - centre;
                away.z() = std::min(0.0, away.z());
                is_reached = is_reached || away.squaredNorm() <= R * R;
            }
            if (!is_reached)
                return false;
        }
    return true;
}

TEST(PathBoundAttack, NoRandomCoveringPathIsShorter)
{
    for (const double c : {std::numeric_limits<double>::infinity(), 64.0}) {
        const Graph part{c};
        const test::SidedSurfaces surfaces{{std::isinf(c)
                                                ? test::plane(2 * half, 2 * half)
                                                : test::saddle(c / 2, half)}};
        EstimateOptions options;
        options.random_places = 2000;
        const PathBound bound =
            path_bound(surfaces.surfaces, surfaces.sides, test::usual_problem(), options);
        std::mt19937_64 engine{7};
        std::uniform_real_distribution<double> share{0, 1};
        double closest = std::numeric_limits<double>::infinity();
        for (int k = 0; k < 20; ++k) {
            const double angle = std::numbers::pi * share(engine);
            const double start = share(engine);
            const double wave = share(engine);
            Path path;
            for (double pitch = 5.4; pitch > 2; pitch *= 0.97) {
                path = passes(part, angle, pitch, start, wave);
                if (is_covered(part, path))
                    break;
            }
            ASSERT_TRUE(is_covered(part, path));
            const double least = bound.density_mm - path.pieces * bound.disc_mm;
            EXPECT_GT(path.length, least);
            closest = std::min(closest, path.length / bound.density_mm);
        }
        // The attack comes near, so that it would find a bound that is far too large. The
        // limit was set after 1.46 had been seen: on this small part, pieces cost much.
        EXPECT_LT(closest, 1.6);
    }
}

}  // namespace
}  // namespace endmill
