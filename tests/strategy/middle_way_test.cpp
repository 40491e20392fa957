// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/middle_way.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "test_surfaces.h"

namespace endmill {
namespace {

TEST(MiddleWay, RunsAlongTheMiddleOfAStrip)
{
    const std::vector<Surface> surfaces{test::plane(20, 10)};
    const std::vector<double> sides{1};
    const PartSamples samples{surfaces, sides, 0.5, 100'000};
    std::vector<std::int32_t> island;
    std::vector<double> depths(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        depths[i] = 2 - std::abs(samples.point(i).y() - 5);
        if (depths[i] > 0)
            island.push_back(static_cast<std::int32_t>(i));
    }
    const std::vector<std::int32_t> way = middle_way(samples, island, depths);
    ASSERT_GT(way.size(), 20u);
    EXPECT_NEAR(std::abs(samples.point(way.back()).x() - samples.point(way.front()).x()),
                20, 0.5);
    for (std::size_t k = 0; k + 1 < way.size(); ++k)
        EXPECT_EQ(std::ranges::count(samples.neighbours(way[k]), way[k + 1]), 1);
    for (const std::int32_t i : way) {
        const Vec3& point = samples.point(i);
        EXPECT_GT(depths[i], 0);
        if (point.x() > 4 && point.x() < 16) {
            EXPECT_NEAR(point.y(), 5, 0.5);
        }
    }
}

TEST(MiddleWay, OfOneSampleIsTheSample)
{
    const std::vector<Surface> surfaces{test::plane(20, 10)};
    const std::vector<double> sides{1};
    const PartSamples samples{surfaces, sides, 2, 100'000};
    const std::vector<double> depths(samples.size(), 1);
    const std::vector<std::int32_t> island{7};
    EXPECT_EQ(middle_way(samples, island, depths), island);
}

}  // namespace
}  // namespace endmill
