// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/cover_radius.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/visibility/sphere_grid.h"
#include "random.h"

namespace endmill {
namespace {

// The largest distance of random directions from the nearest centre approaches the covering
// radius from below.
TEST(CoverRadius, IsTheFarthestOfManyDirections)
{
    const std::vector<Vec3> centres = sphere_grid("hex:10").centres;
    const double radius = cover_radius(centres);
    test::Random random{7};
    double farthest = 0;
    for (int k = 0; k < 20000; ++k) {
        Vec3 direction{random.uniform(-1, 1), random.uniform(-1, 1),
                       random.uniform(-1, 1)};
        direction.normalize();
        double cosine = -1;
        for (const Vec3& centre : centres)
            cosine = std::max(cosine, direction.dot(centre));
        farthest = std::max(farthest, std::acos(std::min(cosine, 1.0)));
    }
    EXPECT_LE(farthest, radius + 1e-12);
    EXPECT_GT(farthest, 0.9 * radius);
}

// The twelve corners of an icosahedron: the farthest directions are the centres of its faces,
// at acos sqrt((5 + 2 sqrt 5) / 15) = 37.4 degrees, which is too far. With the centres of the
// faces added, the farthest directions lie between two corners and two faces.
TEST(CoverRadius, OfIcosahedronCornersAndFaceCentresIsKnown)
{
    const double g = std::numbers::phi;
    std::vector<Vec3> corners;
    for (const double a : {-1.0, 1.0})
        for (const double b : {-g, g}) {
            corners.push_back(Vec3{0, a, b}.normalized());
            corners.push_back(Vec3{a, b, 0}.normalized());
            corners.push_back(Vec3{b, 0, a}.normalized());
        }
    std::vector<Vec3> centres = corners;
    const auto adjacent = [&](const Vec3& p, const Vec3& q) {
        return std::acos(p.dot(q)) < 1.2;  // the edge spans 63.4 degrees
    };
    for (std::size_t i = 0; i < 12; ++i)
        for (std::size_t j = 0; j < i; ++j)
            for (std::size_t k = 0; k < j; ++k)
                if (adjacent(corners[i], corners[j]) &&
                    adjacent(corners[j], corners[k]) && adjacent(corners[i], corners[k]))
                    centres.push_back(
                        (corners[i] + corners[j] + corners[k]).normalized());
    ASSERT_EQ(centres.size(), 32U);
    // By symmetry a farthest direction lies on the plane of symmetry between two faces: equally
    // far from a corner A, the face centres F, G beside it. It is the pole of the circle A, F, G.
    double largest = 0;
    for (std::size_t i = 12; i < 32; ++i)
        for (std::size_t j = 12; j < i; ++j)
            if (std::acos(centres[i].dot(centres[j])) < 0.74)  // neighbours: 41.8 degrees
                for (const Vec3& corner : corners)
                    if (corner.dot(centres[i]) > 0.79 && corner.dot(centres[j]) > 0.79) {
                        const Vec3 pole =
                            (centres[i] - corner).cross(centres[j] - corner).normalized();
                        largest =
                            std::max(largest, std::acos(std::abs(pole.dot(corner))));
                    }
    EXPECT_NEAR(cover_radius(centres), largest, 1e-14);
}

}  // namespace
}  // namespace endmill
