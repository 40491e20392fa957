// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/triangle_drop.h"

#include <gtest/gtest.h>

#include "random.h"
#include "test_meshes.h"

namespace endmill {
namespace {

constexpr double radius = 2;

std::array<Vec3, 3> random_triangle(test::Random& random)
{
    const Vec3 centre = test::random_point(random, 1.5);
    const double size = random.log_uniform(0.01, 3);
    return {centre + test::random_point(random, size),
            centre + test::random_point(random, size),
            centre + test::random_point(random, size)};
}

// The height of the tip on a point, with the axis at the origin.
double tip_on(const Vec3& q)
{
    const double distance = q.head<2>().norm();
    return distance <= radius
               ? q.z() - radius + std::sqrt(radius * radius - distance * distance)
               : -100;
}

// Many points of many triangles, some without area.
TEST(HighestCorner, BoundsTheTipOnTheWholeTriangle)
{
    test::Random random{1};
    int touched = 0;
    for (int k = 0; k < 3000; ++k) {
        auto corners = random_triangle(random);
        if (k % 7 == 0)
            corners[2] = corners[k % 2];
        const auto found = highest_corner(corners, 0, 0, radius);
        if (!found)
            continue;
        EXPECT_NEAR(tip_on(corners[found->corner]), found->tip_z, 1e-12);
        EXPECT_GE(found->bound, found->tip_z);
        touched += found->bound == found->tip_z;
        const auto& [a, b, c] = corners;
        for (int sample = 0; sample < 100; ++sample) {
            const double u = random.uniform(0, 1);
            const double v = random.uniform(0, 1 - u);
            EXPECT_LE(tip_on(a + u * (b - a) + v * (c - a)), found->bound + 1e-12);
        }
        for (const Vec3& corner : corners)
            EXPECT_LE(tip_on(corner), found->tip_z + 1e-12);
    }
    EXPECT_GT(touched, 500);
}

// A small triangle on a slope of 45 degrees beside the touching point of its plane. The
// error of the tangents is proportional to the square of its size.
TEST(HighestCorner, BoundsSmallTrianglesClosely)
{
    const Vec3 touched{std::sqrt(2.0), 0, 0};
    for (const double size : {0.1, 0.01}) {
        const Vec3 a = touched - Vec3{size / 3, size / 3, size / 3};
        const auto found = highest_corner(
            {a, a + Vec3{size, 0, size}, a + Vec3{0, size, 0}}, 0, 0, radius);
        ASSERT_TRUE(found);
        EXPECT_GT(found->bound, tip_on(touched));
        EXPECT_LT(found->bound, tip_on(touched) + 3 * size * size / radius);
    }
}

TEST(HighestCorner, IgnoresTrianglesOutsideOrAtTheRim)
{
    const auto found_at = [](double x) {
        return highest_corner({Vec3{x, 0, 0}, Vec3{x + 9, 0, 0}, Vec3{x, 9, -9}}, 0, 0,
                              radius)
            .has_value();
    };
    EXPECT_TRUE(found_at(1.99));
    EXPECT_FALSE(found_at(1.9999));
    EXPECT_FALSE(found_at(2));
    EXPECT_FALSE(found_at(3));
}

}  // namespace
}  // namespace endmill
