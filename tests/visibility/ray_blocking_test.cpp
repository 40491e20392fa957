// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/ray_blocking.h"

#include <cmath>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Corners = std::array<Vec3, 3>;

Kernel::Point_3 exact(const Vec3& point)
{
    return {point.x(), point.y(), point.z()};
}

bool blocks_by_cgal(const Corners& from, const Vec3& direction, const Corners& facet)
{
    const Kernel::Point_3 start =
        CGAL::centroid(exact(from[0]), exact(from[1]), exact(from[2]));
    const Kernel::Vector_3 along{direction.x(), direction.y(), direction.z()};
    const Kernel::Triangle_3 triangle{exact(facet[0]), exact(facet[1]), exact(facet[2])};
    return CGAL::do_intersect(Kernel::Ray_3{start, along}, triangle);
}

bool has_area(const Corners& corners)
{
    return !CGAL::collinear(exact(corners[0]), exact(corners[1]), exact(corners[2]));
}

template <typename Next>
Corners corners_of(const Next& next)
{
    Corners corners;
    for (Vec3& corner : corners)
        corner = {next(), next(), next()};
    return corners;
}

// Compares `trials` random rays with exact constructions. \return how many rays are
// blocked.
template <typename Next>
int agreed_hits(int trials, const Next& next)
{
    int hits = 0;
    for (int trial = 0; trial < trials; ++trial) {
        const Corners from = corners_of(next);
        const Corners facet = corners_of(next);
        const Vec3 direction{next(), next(), next()};
        if (direction.isZero(0) || !has_area(facet))
            continue;
        const bool expected = blocks_by_cgal(from, direction, facet);
        EXPECT_EQ(blocks_ray(from, direction, facet), expected);
        hits += expected;
    }
    return hits;
}

TEST(BlocksRay, AgreesWithExactConstructionsForRandomNumbers)
{
    test::Random random{1};
    EXPECT_GT(agreed_hits(100000, [&] { return random.uniform(-1, 1); }), 5000);
}

TEST(BlocksRay, AgreesWithExactConstructionsForTouchesAndCommonPlanes)
{
    test::Random random{2};
    EXPECT_GT(agreed_hits(100000, [&] { return std::round(random.uniform(-2, 2)); }),
              5000);
}

TEST(BlocksRay, DependsOnTheLastBitOfACorner)
{
    // The ray rises at (1, 1), a point of the facet's side from (0, 1) to (2, 1).
    const Corners from{Vec3{0, 0, 0}, {3, 0, 0}, {0, 3, 0}};
    const Vec3 up{0, 0, 1};
    EXPECT_TRUE(blocks_ray(from, up, {Vec3{0, 1, 1}, {2, 1, 1}, {1, 3, 1}}));
    EXPECT_TRUE(blocks_ray(from, up, {Vec3{2, 1, 1}, {0, 1, 1}, {1, 3, 1}}));
    const double above = std::nextafter(1, 2);
    EXPECT_FALSE(blocks_ray(from, up, {Vec3{0, above, 1}, {2, above, 1}, {1, 3, 1}}));
    EXPECT_FALSE(blocks_ray(from, -up, {Vec3{0, 1, 1}, {2, 1, 1}, {1, 3, 1}}));
}

TEST(BlocksRay, BlocksAtTheStart)
{
    const Corners from{Vec3{0, 0, 0}, {3, 0, 0}, {0, 3, 0}};
    EXPECT_TRUE(blocks_ray(from, {0, 0, 1}, from));
    EXPECT_TRUE(blocks_ray(from, {1, 0, 1}, {Vec3{1, 1, 0}, {5, 1, -1}, {5, 2, -1}}));
    EXPECT_FALSE(
        blocks_ray(from, {-1, 0, 1}, {Vec3{1, 1, -1e-300}, {5, 1, -1}, {5, 2, -1}}));
}

TEST(BlocksRay, IsTheSameForAnySize)
{
    const Corners from{Vec3{0, 0, 0}, {3, 0, 0}, {0, 3, 0}};
    const Corners facet{Vec3{0, 1, 1}, {2, 1, 1}, {1, 3, 1}};
    for (const double size : {0x1p-500, 0x1p-100, 0x1p100, 0x1p500}) {
        Corners small_from = from;
        Corners small_facet = facet;
        for (int k = 0; k < 3; ++k) {
            small_from[k] *= size;
            small_facet[k] *= size;
        }
        EXPECT_TRUE(blocks_ray(small_from, {0, 0, 1}, small_facet));
        EXPECT_FALSE(blocks_ray(small_from, {0, -1, 1}, small_facet));
    }
}

// Scaling by a power of two changes no digit of the coordinates. The answer must stay the
// same even if products of coordinates overflow.
TEST(BlocksRay, IsRightIfProductsOverflow)
{
    test::Random random{3};
    const auto next = [&] { return random.uniform(-1, 1); };
    for (int trial = 0; trial < 5000; ++trial) {
        Corners from = corners_of(next);
        Corners facet = corners_of(next);
        const Vec3 direction{next(), next(), next()};
        const bool expected = blocks_ray(from, direction, facet);
        for (int k = 0; k < 3; ++k) {
            from[k] *= 0x1p511;
            facet[k] *= 0x1p511;
        }
        EXPECT_EQ(blocks_ray(from, direction, facet), expected);
    }
}

}  // namespace
}  // namespace endmill
