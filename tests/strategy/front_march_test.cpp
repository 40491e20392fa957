// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/front_march.h"

#include <cmath>

#include <gtest/gtest.h>

#include "test_surfaces.h"

namespace endmill {
namespace {

// On a plane a ball of radius 5 leaves a scallop of 1 mm between passes 6 mm apart.
TEST(FrontMarch, LaysPassesOfAPlaneAtTheirClosedDistance)
{
    const std::vector<Surface> surfaces{test::plane(60, 45)};
    const std::vector<double> sides{1};
    const PartSamples samples{surfaces, sides, 0.5, 100'000};
    Coverage coverage{samples, BallCutter{5}, 1};
    FrontMarch march{coverage, 1e-6, 6};
    std::vector<SampleEdge> side;
    for (std::size_t i = 0; i < samples.size(); ++i)
        if (samples.point(i).y() == 0)
            side.push_back(
                {static_cast<std::int32_t>(i), static_cast<std::int32_t>(i), 0});
    march.run(side);
    EXPECT_TRUE(march.is_complete());
    const std::span<const LevelLine> passes = march.passes();
    ASSERT_EQ(passes.size(), 8u);  // at 3, 9, …, 39, and one for the rest
    for (std::size_t k = 0; k < 7; ++k)
        for (const SampleEdge& place : passes[k].places)
            EXPECT_NEAR(samples.contact(place).at.contact.point.y(), 3 + 6.0 * double(k),
                        0.02 * double(k + 1));
}

TEST(FrontMarch, RunsAroundTheBorder)
{
    const std::vector<Surface> surfaces{test::plane(40, 40)};
    const std::vector<double> sides{1};
    const PartSamples samples{surfaces, sides, 0.5, 100'000};
    Coverage coverage{samples, BallCutter{5}, 1};
    FrontMarch march{coverage, 1e-3, 6};
    std::vector<SampleEdge> border;
    for (const auto& [a, b] : samples.border())
        border.push_back({a, a, 0}), border.push_back({b, b, 0});
    march.run(border);
    EXPECT_TRUE(march.is_complete());
    EXPECT_TRUE(march.passes()[0].is_closed);
}

}  // namespace
}  // namespace endmill
