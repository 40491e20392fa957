// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/cylinder_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

using Corners = std::array<Vec3, 3>;

// Distance of a point from the cylinder, 0 inside.
double distance(const SolidCylinder& cylinder, const Vec3& point)
{
    const Vec3 offset = point - cylinder.start;
    const double height = offset.dot(cylinder.axis);
    const double across = (offset - height * cylinder.axis).norm();
    return std::hypot(std::max(0.0, across - cylinder.radius),
                      std::max({0.0, cylinder.from - height, height - cylinder.to}));
}

// Least distance of sample points of the triangle; every point of the triangle is within
// `spacing` of a sample.
double sampled_distance(const SolidCylinder& cylinder, const Corners& corners, int steps)
{
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; i + j <= steps; ++j)
            least = std::min(least, distance(cylinder, (i * corners[0] + j * corners[1] +
                                                        (steps - i - j) * corners[2]) /
                                                           steps));
    return least;
}

double longest_side(const Corners& corners)
{
    return std::max({(corners[1] - corners[0]).norm(), (corners[2] - corners[1]).norm(),
                     (corners[0] - corners[2]).norm()});
}

TEST(CylinderMeets, AgreesWithSamplesOfTheTriangle)
{
    constexpr int steps = 60;
    test::Random random{11};
    const auto vector = [&] {
        return Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    };
    int hits = 0;
    int misses = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const double from = random.uniform(0, 1);
        const SolidCylinder cylinder{vector(), vector().normalized(),
                                     random.uniform(0.01, 0.5), from,
                                     from + random.uniform(0.01, 1)};
        const Corners corners{vector(), vector(), vector()};
        const double sampled = sampled_distance(cylinder, corners, steps);
        if (sampled == 0) {
            EXPECT_TRUE(meets(cylinder, corners));
            ++hits;
        } else if (sampled > longest_side(corners) / steps) {
            EXPECT_FALSE(meets(cylinder, corners));
            ++misses;
        }
    }
    EXPECT_GT(hits, 100);
    EXPECT_GT(misses, 700);
}

TEST(CylinderMeets, ATriangleThatTouchesIt)
{
    const SolidCylinder cylinder{{0, 0, 0}, {0, 0, 1}, 2, 1, 3};
    EXPECT_TRUE(meets(cylinder, {Vec3{-9, -9, 1}, {9, -9, 1}, {0, 9, 1}}));  // lower end
    EXPECT_TRUE(meets(cylinder, {Vec3{-9, -9, 3}, {9, -9, 3}, {0, 9, 3}}));  // upper end
    EXPECT_TRUE(meets(cylinder, {Vec3{2, -9, 0}, {2, 9, 0}, {2, 0, 9}}));    // side
    EXPECT_TRUE(meets(cylinder, {Vec3{2, 0, 3}, {3, 0, 4}, {3, 1, 4}}));  // rim, a corner
    EXPECT_FALSE(meets(cylinder, {Vec3{-9, -9, 0.99}, {9, -9, 0.99}, {0, 9, 0.99}}));
    EXPECT_FALSE(meets(cylinder, {Vec3{2.001, -9, 0}, {2.001, 9, 0}, {2.001, 0, 9}}));
    // Within the radius of the end of the axis, but outside of the flat end.
    EXPECT_FALSE(meets(cylinder, {Vec3{0, 0, 3.001}, {1, 0, 3.5}, {0, 1, 3.5}}));
}

TEST(CylinderMeets, ATriangleThatItPasses)
{
    const SolidCylinder thin{{0.1, 0.2, -5}, {0, 0, 1}, 1e-3, 0, 10};
    const Corners corners{Vec3{-9, -9, 0}, {9, -9, 1}, {0, 9, 2}};
    EXPECT_TRUE(meets(thin, corners));
    EXPECT_TRUE(meets(thin, {corners[0], corners[2], corners[1]}));
    SolidCylinder short_one = thin;
    short_one.to = 5;
    EXPECT_FALSE(meets(short_one, corners));
}

TEST(CylinderMayMeet, ExcludesNoContact)
{
    test::Random random{12};
    const auto vector = [&] {
        return Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    };
    int ruled_out = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        const SolidCylinder cylinder{vector(), vector().normalized(),
                                     random.uniform(0.01, 0.3), 0.1,
                                     random.uniform(0.2, 1)};
        const Vec3 place = 2 * vector();
        const Corners corners{place + 0.3 * vector(), place + 0.3 * vector(),
                              place + 0.3 * vector()};
        const Vec3 low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
        const Vec3 high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
        const bool may = may_meet(cylinder, low, high);
        EXPECT_TRUE(may || !meets(cylinder, corners));
        ruled_out += !may;
    }
    EXPECT_GT(ruled_out, 10000);
}

}  // namespace
}  // namespace endmill
