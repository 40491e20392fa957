// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/starts.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "test_surfaces.h"

namespace endmill {
namespace {

TEST(MarchStarts, OfARectangleAreItsBorderItsSidesAndSections)
{
    const std::vector<Surface> surfaces{test::plane(20, 10)};
    const std::vector<double> sides{1};
    const PartSamples samples{surfaces, sides, 1, 100'000};
    const std::vector<MarchStart> starts = march_starts(samples);
    EXPECT_EQ(starts.size(), 1u + 4u + 12u);
    for (const MarchStart& start : starts) {
        Coverage coverage{samples, BallCutter{5}, 1};
        EXPECT_FALSE(lay_passes(coverage, start, 0.01, 6).empty());
        EXPECT_TRUE(
            std::ranges::all_of(coverage.gaps(), [](double gap) { return gap <= 0.01; }));
    }
}

// Two parts that no front joins.
TEST(MarchStarts, CoverEveryComponent)
{
    const std::vector<Surface> surfaces{
        test::plane(20, 10), test::graph(test::monomial(0, 0, 0), {{30, 50}, {0, 10}})};
    const std::vector<double> sides{1, 1};
    const PartSamples samples{surfaces, sides, 1, 100'000};
    Coverage coverage{samples, BallCutter{5}, 1};
    const std::vector<LaidPass> passes = lay_passes(coverage, LineStart{0, 0.5}, 0.01, 6);
    EXPECT_TRUE(
        std::ranges::all_of(coverage.gaps(), [](double gap) { return gap <= 0.01; }));
    EXPECT_GE(passes.size(), 2u);
}

}  // namespace
}  // namespace endmill
