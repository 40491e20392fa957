// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/detail/point_tree.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "random.h"

namespace endmill {
namespace {

constexpr double everywhere = std::numeric_limits<double>::infinity();

double least_distance(const std::vector<Vec3>& points, const Vec3& place)
{
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3& point : points)
        least = std::min(least, (point - place).norm());
    return least;
}

Vec3 random_point(test::Random& random, double size)
{
    const double x = random.uniform(-size, size);
    const double y = random.uniform(-size, size);
    return {x, y, random.uniform(-size, size)};
}

void expect_nearest(const std::vector<Vec3>& points, test::Random& random, double reach)
{
    const PointTree tree{points};
    for (int k = 0; k < 200; ++k) {
        const Vec3 place = random_point(random, reach);
        EXPECT_EQ((points[*tree.nearest_within(place, everywhere)] - place).norm(),
                  least_distance(points, place));
    }
}

TEST(PointTree, FindsTheSameAsTestingEveryPoint)
{
    test::Random random{1};
    for (const int count : {1, 2, 3, 4, 7, 64, 1000}) {
        std::vector<Vec3> points(count);
        for (Vec3& point : points)
            point = random_point(random, 1);
        expect_nearest(points, random, 2);
    }
}

TEST(PointTree, FindsTheNearestOfPointsWithManyEqualCoordinates)
{
    test::Random random{2};
    std::vector<Vec3> points(1000);
    for (int k = 0; k < 1000; ++k)
        points[k] = {double(k % 5), double(k / 5 % 5), double(k % 2)};
    std::ranges::shuffle(points, random.engine());
    expect_nearest(points, random, 6);
}

TEST(PointTree, FindsTheNearestOfPointsOnALineAndInAPlane)
{
    test::Random random{3};
    std::vector<Vec3> line;
    std::vector<Vec3> plane;
    for (int k = 0; k < 500; ++k) {
        line.emplace_back(random.uniform(0, 1) * Vec3{0, 1, 0});
        plane.emplace_back(random.uniform(-1, 1), 0.5, random.uniform(-1, 1));
    }
    expect_nearest(line, random, 1);
    expect_nearest(plane, random, 1);
}

TEST(PointTree, FindsEveryPointOfItsOwn)
{
    test::Random random{4};
    std::vector<Vec3> points(300);
    for (Vec3& point : points)
        point = random_point(random, 1e6);
    const PointTree tree{points};
    for (std::size_t k = 0; k < points.size(); ++k)
        EXPECT_EQ(*tree.nearest_within(points[k], everywhere), k);
}

TEST(PointTree, OfEqualPointsFindsTheSameEachTime)
{
    const std::vector<Vec3> points(100, Vec3{1, 2, 3});
    const std::size_t first = *PointTree{points}.nearest_within({0, 0, 0}, everywhere);
    EXPECT_LT(first, points.size());
    EXPECT_EQ(*PointTree{points}.nearest_within({0, 0, 0}, everywhere), first);
}

TEST(PointTree, FindsTheNearestAmongManyCopiesOfEachPoint)
{
    test::Random random{5};
    std::vector<Vec3> points;
    for (int k = 0; k < 20; ++k)
        points.insert(points.end(), 60, random_point(random, 1));
    std::ranges::shuffle(points, random.engine());
    expect_nearest(points, random, 2);
    const PointTree tree{points};
    for (int k = 0; k < 200; ++k) {
        const Vec3 place = random_point(random, 2);
        const double least = least_distance(points, place);
        EXPECT_FALSE(tree.nearest_within(place, least * (1 - 1e-12)));
        EXPECT_TRUE(tree.nearest_within(place, least * (1 + 1e-12)));
    }
}

TEST(PointTree, DistinguishesPointsByHeightFromFarAway)
{
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 1}, {0, 1, 2}, {-1, 0, 3}};
    EXPECT_EQ(*PointTree{points}.nearest_within({0, 0, 1e6}, everywhere), 3U);
    EXPECT_EQ(*PointTree{points}.nearest_within({0, 0, -1e6}, everywhere), 0U);
}

TEST(PointTree, RefusesNoPoints)
{
    EXPECT_THROW(PointTree{std::span<const Vec3>{}}, DomainError);
}

TEST(PointTree, FindsNothingOutsideTheRadius)
{
    const std::vector<Vec3> points{{1, 0, 0}, {0, 3, 0}};
    const PointTree tree{points};
    EXPECT_FALSE(tree.nearest_within({0, 0, 0}, 1));
    EXPECT_EQ(tree.nearest_within({0, 0, 0}, 1.001), 0U);
    EXPECT_EQ(tree.nearest_within({0, 2.5, 0}, 1), 1U);
}

}  // namespace
}  // namespace endmill
