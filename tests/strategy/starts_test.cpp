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
        EXPECT_FALSE(lay_lines(coverage, start, 0.01, 6).empty());
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
    const std::vector<LevelLine> passes = lay_lines(coverage, LineStart{0, 0.5}, 0.01, 6);
    EXPECT_TRUE(
        std::ranges::all_of(coverage.gaps(), [](double gap) { return gap <= 0.01; }));
    EXPECT_GE(passes.size(), 2u);
}

TEST(PassesOn, AreTheContactsOfTheirLines)
{
    const std::vector<Surface> surfaces{test::plane(20, 10)};
    const std::vector<double> sides{1};
    const PartSamples samples{surfaces, sides, 1, 100'000};
    const std::vector<LevelLine> lines{{{{0, 1, 0.25}, {1, 1, 0}}, false},
                                       {{{2, 2, 0}}, true}};
    const std::vector<LaidPass> passes = passes_on(lines, samples);
    ASSERT_EQ(passes.size(), 2u);
    ASSERT_EQ(passes[0].contacts.size(), 2u);
    EXPECT_LT((passes[0].contacts[0].at.contact.point -
               (0.75 * samples.point(0) + 0.25 * samples.point(1)))
                  .norm(),
              1e-9);
    EXPECT_EQ(passes[0].contacts[1].at.contact.point, samples.point(1));
    EXPECT_TRUE(passes[1].is_closed);
}

}  // namespace
}  // namespace endmill
