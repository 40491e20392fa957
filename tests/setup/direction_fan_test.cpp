// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/direction_fan.h"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "direction_sets.h"

namespace endmill {
namespace {

using test::degree;
using test::direction;
using test::directions;
using test::up;

TEST(DirectionFan, ListsDirectionsTwiceByAzimuth)
{
    const DirectionFan fan{
        PolePoints{up, directions({{350, 30}, {10, 50}, {10, 20}, {0, 0}})}};
    ASSERT_EQ(fan.size(), 3U);
    const test::AzimuthPolar sorted[] = {{10, 20}, {10, 50}, {350, 30}};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(fan.azimuth(i), sorted[i].azimuth * degree, 1e-14);
        EXPECT_NEAR(fan.polar(i), sorted[i].polar * degree, 1e-14);
        EXPECT_EQ(fan.azimuth(i + 3), fan.azimuth(i) + 2 * std::numbers::pi);
        EXPECT_EQ(fan.polar(i + 3), fan.polar(i));
    }
    EXPECT_NEAR(fan.largest_polar(), 50 * degree, 1e-14);
}

TEST(DirectionFan, CountsADirectionOppositeToThePoleInTheHigherSector)
{
    const DirectionFan fan{PolePoints{up, directions({{0, 30}, {90, 40}, {0, 180}})}};
    EXPECT_EQ(fan.size(), 2U);
    EXPECT_NEAR(fan.largest_polar(), std::numbers::pi, 1e-14);
    const SectorCandidate sector = fan.candidate(0, 1, 0.5, 0.6);
    EXPECT_EQ(sector.polar, 0.5);
    EXPECT_EQ(sector.opposite_polar, fan.largest_polar());
}

TEST(RunMaximum, IsTheLargestOfEachRun)
{
    test::Random random{63};
    for (int i = 0; i < 100; ++i) {
        std::vector<Vec3> points;
        for (int k = 0; k <= i; ++k)
            points.push_back(direction({random.uniform(0, 360), random.uniform(1, 9)}));
        const DirectionFan fan{PolePoints{up, points}};
        RunMaximum maximum{fan};
        std::size_t begin = 0;
        std::size_t end = 0;
        while (end < 2 * fan.size()) {
            end = std::min(end + static_cast<std::size_t>(random.uniform(0, 4)),
                           2 * fan.size());
            begin = std::min(begin + static_cast<std::size_t>(random.uniform(0, 4)), end);
            double expected = 0;
            for (std::size_t k = begin; k < end; ++k)
                expected = std::max(expected, fan.polar(k));
            EXPECT_EQ(maximum.of(begin, end), expected);
        }
    }
}

}  // namespace
}  // namespace endmill
