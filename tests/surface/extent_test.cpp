// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/extent.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr double share = 1e-9;  // of the diagonal, as the header states

Interval sampled_extent(const Surface& surface, const Vec3& direction, int per_patch)
{
    Interval extent{1e300, -1e300};
    const int columns = per_patch * surface.patches(Parameter::U);
    const int rows = per_patch * surface.patches(Parameter::V);
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            const double height =
                surface.tangents(column / double(per_patch), row / double(per_patch))
                    .point.dot(direction);
            extent.low = std::min(extent.low, height);
            extent.high = std::max(extent.high, height);
        }
    return extent;
}

TEST(Extent, CoversEverySampleAndLittleMore)
{
    test::Random random{1};
    for (unsigned seed = 0; seed < 6; ++seed) {
        const Surface surface = test::random_surface(seed, {2, 2}, 12);
        const Vec3 direction =
            Vec3{random.uniform(-1, 1), random.uniform(-1, 1), 1}.normalized();
        const Interval found = extent(surface, direction);
        const Interval sampled = sampled_extent(surface, direction, 60);
        EXPECT_LE(found.low, sampled.low + share * surface.diagonal());
        EXPECT_GE(found.high, sampled.high - share * surface.diagonal());
        EXPECT_GE(found.low, sampled.low - 1e-3 * surface.diagonal());
        EXPECT_LE(found.high, sampled.high + 1e-3 * surface.diagonal());
    }
}

// For z = c (x - p)^2 - c (y - q)^2 the extremes over a square are on its sides at x = p
// and y = q, not at samples of a grid.
TEST(Extent, OfASaddleIsThatOfItsClosedForm)
{
    constexpr double p = 0.123456789;
    constexpr double q = -0.6180339887;
    constexpr double c = 0.7;
    const Surface surface =
        test::graph(test::monomial(2, 0, c) + test::monomial(1, 0, -2 * c * p) +
                        test::monomial(0, 2, -c) + test::monomial(0, 1, 2 * c * q) +
                        test::monomial(0, 0, c * (p * p - q * q)),
                    {{-1, 1}, {-1, 1}}, {3, 2});
    const auto [low, high] = extent(surface, Vec3::UnitZ());
    const double tolerance = share * surface.diagonal();
    EXPECT_NEAR(low, -c * (1 - q) * (1 - q), tolerance);
    EXPECT_NEAR(high, c * (1 + p) * (1 + p), tolerance);
    EXPECT_GE(low, -c * (1 - q) * (1 - q) - 1e-15);
    EXPECT_LE(high, c * (1 + p) * (1 + p) + 1e-15);
}

TEST(Extent, OfARidgeAskewToTheParametersIsItsCrest)
{
    // z = -(x - y / 3 - 0.1234)^2 has its maximum 0 along a whole line.
    constexpr double a = 1.0 / 3;
    constexpr double b = 0.1234;
    const Surface ridge =
        test::graph(test::monomial(2, 0, -1) + test::monomial(1, 1, 2 * a) +
                        test::monomial(0, 2, -a * a) + test::monomial(1, 0, 2 * b) +
                        test::monomial(0, 1, -2 * a * b) + test::monomial(0, 0, -b * b),
                    {{-1, 1}, {-1, 1}});
    const double high = extent(ridge, Vec3::UnitZ()).high;
    EXPECT_GE(high, -share * ridge.diagonal());
    EXPECT_LE(high, 1e-15);
}

TEST(Extent, OfAPlaneIsThatOfItsCorners)
{
    const Surface plane = test::parallelogram({3, 1, 2}, {-1, 4, 1}, {2, 3});
    const auto [low, high] = extent(plane, Vec3::UnitX());
    EXPECT_NEAR(low, -1, 1e-15);
    EXPECT_NEAR(high, 3, 1e-15);
}

TEST(Extent, AcrossAPlaneIsZero)
{
    const auto [low, high] = extent(test::plane(200, 120, {3, 2}), Vec3::UnitZ());
    EXPECT_EQ(low, 0);
    EXPECT_EQ(high, 0);
}

TEST(Extent, OfASinglePointIsThatPoint)
{
    const std::vector<Vec3> net(16, Vec3{1, 2, 3});
    const auto [low, high] = extent(composite_bezier(1, 1, net), Vec3::UnitY());
    EXPECT_EQ(low, 2);
    EXPECT_EQ(high, 2);
}

TEST(Extent, ScalesWithTheDirectionAndTurnsWithItsSign)
{
    const Surface surface = test::random_surface(3, {2, 1});
    const Vec3 direction{0.3, -0.4, 0.5};
    const Interval once = extent(surface, direction);
    const Interval opposite = extent(surface, -direction);
    EXPECT_EQ(opposite.low, -once.high);
    EXPECT_EQ(opposite.high, -once.low);
}

}  // namespace
}  // namespace endmill
