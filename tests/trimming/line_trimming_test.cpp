// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/line_trimming.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(SearchByLines, FindsTheCrossingOfConvexBranches)
{
    std::vector<SectionPoint> points;
    for (int i = -20; i <= 4; ++i)  // A falls to its cusp, which is right of the z axis
        points.emplace_back(0.1 * i, 0.01 * (i - 8) * (i - 8));
    const auto cusp_a = static_cast<std::int32_t>(points.size()) - 1;
    for (int i = -4; i <= 20; ++i)  // B is the mirror image of A
        points.emplace_back(0.1 * i, 0.01 * (i + 8) * (i + 8));
    const SectionChain chain{points, 0};
    const Branches branches{0, cusp_a, cusp_a + 1, chain.last()};
    const auto crossing = search_by_lines(chain, branches, {});
    ASSERT_TRUE(crossing);
    EXPECT_NEAR(crossing->at.x(), 0, 1e-15);
    EXPECT_NEAR(crossing->at.y(), 0.64, 1e-15);
}

// The end of the first branch does not reach the s of the second cusp.
TEST(SearchByLines, NeedsBothBranchesToReachTheOthersCusp)
{
    const std::vector<SectionPoint> points{{-1, 1}, {2, -2}, {0, -1}, {-2, -2}, {6, 6}};
    const SectionChain chain{points, 0};
    EXPECT_FALSE(search_by_lines(chain, {0, 1, 3, 4}, {}));
}

// The iteration goes from segment 0 to 5, to 2, to 4 and back to 0. It stops without a
// result and misses the crossing of the segments 2 and 5.
TEST(SearchByLines, EndsWhereItDoesNotConverge)
{
    const std::vector<SectionPoint> points{{-5, 7}, {0, 4},  {1, -5}, {3, -3},
                                           {-5, 7}, {2, -9}, {4, 7},  {6, 9}};
    const SectionChain chain{points, 0};
    const Branches branches{0, 3, 4, 7};
    EXPECT_EQ(first_crossed_of_b(chain, branches, 0), 5);
    EXPECT_EQ(first_crossed_of_a(chain, branches, 5), 2);
    EXPECT_EQ(first_crossed_of_b(chain, branches, 2), 4);
    EXPECT_EQ(first_crossed_of_a(chain, branches, 4), 0);
    const auto missed = crossing_of(chain, 2, 5, CrossingType::Valley);
    ASSERT_TRUE(missed);
    EXPECT_NEAR(missed->at.x(), 19.0 / 7, 1e-15);
    for (const auto detection : {FoldDetection::Literal, FoldDetection::Guarded})
        EXPECT_FALSE(search_by_lines(chain, branches, {.detection = detection}));
}

}  // namespace
}  // namespace endmill
