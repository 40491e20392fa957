// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/page/reduction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

ToolPath path_of(std::size_t count, auto tip_of)
{
    ToolPath path;
    for (std::size_t k = 0; k < count; ++k)
        path.points.push_back({static_cast<int>(k / 1000),
                               static_cast<int>(k % 1000),
                               Move::Cut,
                               0,
                               {tip_of(k), Vec3::UnitZ()}});
    return path;
}

ToolPath helix(std::size_t count)
{
    return path_of(count, [](std::size_t k) {
        const double turn = 0.01 * static_cast<double>(k);
        return Vec3{20 * std::cos(turn), 20 * std::sin(turn), 0.1 * turn};
    });
}

// The greatest distance of a point of the path from the drawn line over it, by search among
// the two ends and a fine sampling of the line.
double greatest_distance(const ToolPath& path, const ReducedPath& reduced)
{
    double greatest = 0;
    for (std::size_t i = 0; i + 1 < reduced.points.size(); ++i) {
        const Vec3& from = path.points[reduced.points[i]].location.tip;
        const Vec3& to = path.points[reduced.points[i + 1]].location.tip;
        for (std::size_t k = reduced.points[i] + 1; k < reduced.points[i + 1]; ++k) {
            double least = std::numeric_limits<double>::infinity();
            for (int s = 0; s <= 200; ++s)
                least = std::min(
                    least, (path.points[k].location.tip - from - s / 200.0 * (to - from))
                               .norm());
            greatest = std::max(greatest, least);
        }
    }
    return greatest;
}

TEST(ReducedPath, KeepsAShortPathWhole)
{
    const ReducedPath reduced = reduced_path(helix(50), 50);
    EXPECT_EQ(reduced.points.size(), 50U);
    EXPECT_EQ(reduced.tolerance_mm, 0);
    EXPECT_TRUE(reduced_path({}, 2).points.empty());
}

TEST(ReducedPath, StaysWithinItsTolerance)
{
    const ToolPath path = helix(20000);
    for (const std::size_t most : {100U, 1000U, 10000U}) {
        const ReducedPath reduced = reduced_path(path, most);
        EXPECT_LE(reduced.points.size(), most);
        EXPECT_TRUE(std::ranges::is_sorted(reduced.points));
        EXPECT_EQ(reduced.points.front(), 0U);
        EXPECT_EQ(reduced.points.back(), 19999U);
        // the sampled line is at most 1/400 of a chord farther
        EXPECT_LE(greatest_distance(path, reduced), reduced.tolerance_mm * 1.02 + 1e-3);
    }
}

// A chord of a circle of radius R with the height h is sqrt(8 R h) long, so that the number of
// points falls as the root of the tolerance.
TEST(ReducedPath, NeedsAsManyPointsAsACircleAsks)
{
    const ToolPath path = helix(20000);
    const ReducedPath reduced = reduced_path(path, 2000);
    const double length = 20 * 0.01 * 20000;
    const double chord = std::sqrt(8 * 20 * reduced.tolerance_mm);
    const auto points = static_cast<double>(reduced.points.size());
    EXPECT_GT(points, length / chord);
    EXPECT_LT(points, 2.2 * length / chord + 20);  // chords are halved, and passes end
}

TEST(ReducedPath, KeepsTheEndsOfMovesAndPasses)
{
    ToolPath path = path_of(3000, [](std::size_t k) {
        return Vec3{static_cast<double>(k), 0, 0};
    });
    for (std::size_t k = 1500; k < 1600; ++k)
        path.points[k].move = Move::Link;
    const ReducedPath reduced = reduced_path(path, 100);
    EXPECT_EQ(reduced.points, (std::vector<std::size_t>{0, 999, 1499, 1599, 1999, 2999}));
}

TEST(ReducedPath, JoinsMovesIfTheirEndsAreTooMany)
{
    ToolPath path = helix(5000);
    for (std::size_t k = 0; k < path.points.size(); ++k)
        path.points[k].move = k % 2 == 0 ? Move::Cut : Move::Link;
    const ReducedPath reduced = reduced_path(path, 300);
    EXPECT_TRUE(reduced.joins_moves);
    EXPECT_LE(reduced.points.size(), 300U);
    EXPECT_LE(greatest_distance(path, reduced), reduced.tolerance_mm * (1 + 1e-9));
    EXPECT_FALSE(reduced_path(helix(5000), 300).joins_moves);
}

TEST(ReducedPath, TakesAPathThatDividesBadly)
{
    // Every stretch is divided at its first point.
    const ToolPath path = path_of(300000, [](std::size_t k) {
        return Vec3{static_cast<double>(k), std::exp2(-static_cast<double>(k % 900)), 0};
    });
    EXPECT_LE(reduced_path(path, 5000).points.size(), 5000U);
}

TEST(ReducedPath, RefusesLessThanTwoPoints)
{
    EXPECT_THROW(reduced_path(helix(5), 1), DomainError);
}

TEST(Extremes, KeepTheLeastAndTheGreatestOfAll)
{
    std::vector<float> values(10001);
    for (std::size_t k = 0; k < values.size(); ++k)
        values[k] = static_cast<float>(std::sin(0.7 * static_cast<double>(k)));
    values[1234] = 7;
    values[8888] = -9;
    const std::vector<std::size_t> kept = extremes(values, 100);
    EXPECT_LE(kept.size(), 100U);
    EXPECT_TRUE(std::ranges::is_sorted(kept));
    EXPECT_TRUE(std::ranges::binary_search(kept, 1234U));
    EXPECT_TRUE(std::ranges::binary_search(kept, 8888U));
}

TEST(Extremes, SkipWhatIsNotFinite)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> values{nan, 1, nan, 2, nan, nan, nan};
    EXPECT_EQ(extremes(values, 100), (std::vector<std::size_t>{1, 3}));
    EXPECT_EQ(extremes(values, 4), (std::vector<std::size_t>{1, 3}));
    EXPECT_TRUE(extremes(std::vector<float>(9, nan), 4).empty());
    EXPECT_THROW(extremes(values, 1), DomainError);
}

}  // namespace
}  // namespace endmill
