// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/detail/nearest_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/mesh/triangle_tree.h"
#include "test_meshes.h"

namespace endmill {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Four triangles about a point, by their own points.
struct FourTriangles {
    std::vector<Vec3> points;
    std::array<Triangle, 4> triangles;

    FourTriangles(test::Random& random, const Vec3& centre, double size)
    {
        for (std::int32_t k = 0; k < 4; ++k) {
            for (int corner = 0; corner < 3; ++corner)
                points.emplace_back(centre + test::random_point(random, size));
            triangles[k] = {3 * k, 3 * k + 1, 3 * k + 2};
        }
    }

    std::array<Vec3, 3> corners(int k) const
    {
        return {points[3 * k], points[3 * k + 1], points[3 * k + 2]};
    }
};

double margin_of(const FourTriangles& four)
{
    double largest = 0;
    for (const Vec3& point : four.points)
        largest = std::max(largest, point.lpNorm<Eigen::Infinity>());
    return 1e-12 * largest;
}

float down(double value)
{
    const auto rounded = static_cast<float>(value);
    return rounded <= value ? rounded : std::nextafterf(rounded, -infinity);
}

// Each triangle is a part, in the slab about its plane.
FourEnclosures enclosures_of(const FourTriangles& four)
{
    const double margin = margin_of(four);
    FourEnclosures parts;
    for (int k = 0; k < 4; ++k) {
        const auto [a, b, c] = four.corners(k);
        const Vec3 normal =
            (b - a).cross(c - a).stableNormalized().cast<float>().cast<double>();
        for (int axis = 0; axis < 3; ++axis) {
            parts.low[axis][k] = down(std::min({a[axis], b[axis], c[axis]}) - margin);
            parts.high[axis][k] = -down(-std::max({a[axis], b[axis], c[axis]}) - margin);
            parts.normal[axis][k] = static_cast<float>(normal[axis]);
        }
        const auto [low, high] =
            std::minmax({normal.dot(a), normal.dot(b), normal.dot(c)});
        parts.slab_low[k] = down(low - margin);
        parts.slab_high[k] = -down(-high - margin);
    }
    return parts;
}

TEST(BoundSquares, AreNotAboveTheSquaredDistances)
{
    test::Random random{1};
    for (const double scale : {1e-25, 1e-3, 1.0, 1e6, 1e20, 1e27})
        for (const double offset : {0.0, 10.0, 1e3})
            for (int trial = 0; trial < 300; ++trial) {
                const double size = scale * random.log_uniform(1e-6, 1);
                const Vec3 centre = test::random_point(random, scale * offset);
                const FourTriangles four{random, centre, size};
                const Vec3 place =
                    centre +
                    test::random_point(random, size * random.log_uniform(0.1, 1e3));
                const auto of_parts =
                    bound_squares(enclosures_of(four), place, margin_of(four), infinity);
                const auto of_triangles =
                    bound_squares(four.points, four.triangles, place, margin_of(four));
                for (int k = 0; k < 4; ++k) {
                    const Vec3 nearest = nearest_on_triangle(place, four.corners(k));
                    const double square = (nearest - place).squaredNorm();
                    EXPECT_LE(of_parts[k], square);
                    EXPECT_LE(of_triangles[k], square);
                }
            }
}

// The place is above a sloping square, whose box almost reaches it.
TEST(BoundSquares, OfASlopingPartIsThatOfItsSlab)
{
    FourEnclosures parts;
    for (int k = 0; k < 2; ++k) {
        for (int axis = 0; axis < 3; ++axis) {
            parts.low[axis][k] = -1;
            parts.high[axis][k] = 1;
        }
        parts.normal[0][k] = 0.6F;
        parts.normal[2][k] = 0.8F;
    }
    const Vec3 above{0.6, 0.3, 0.8};
    const auto bounds = bound_squares(parts, above, 1e-12, infinity);
    EXPECT_NEAR(bounds[0], 1, 1e-6);
    // the plane through the foot (0.6 - 1.2, 0.3, 0.8 - 1.6), moved into the box
    EXPECT_NEAR(bound_squares(parts, 2 * above, 1e-12, infinity)[1], 4, 1e-6);
    EXPECT_EQ(bounds[2], infinity);
    EXPECT_EQ(bounds[3], infinity);
    // only one box is within the limit
    parts.low[2][1] = 0.9F;
    EXPECT_EQ(bound_squares(parts, above, 1e-12, 0.001)[0], 0);
}

TEST(BoundSquares, OfAPartWithoutNormalIsThatOfItsBox)
{
    FourEnclosures parts;
    for (int k = 0; k < 4; ++k)
        for (int axis = 0; axis < 3; ++axis) {
            parts.low[axis][k] = static_cast<float>(k);
            parts.high[axis][k] = static_cast<float>(k) + 1;
        }
    const auto bounds = bound_squares(parts, {-1, 1.5, 1.25}, 1e-12, infinity);
    EXPECT_NEAR(bounds[0], 1 + 0.25 + 0.0625, 1e-12);
    EXPECT_NEAR(bounds[1], 4, 1e-12);
    EXPECT_NEAR(bounds[2], 9 + 0.25 + 0.5625, 1e-12);
}

}  // namespace
}  // namespace endmill
