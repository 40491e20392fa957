// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/sequence_trimming.h"

#include <gtest/gtest.h>

#include "trimmed_curves.h"

namespace endmill {
namespace {

TEST(TrimRepaired, FindsNestedLoops)
{
    const SectionCurve curve = test::open_curve(
        {{-10, 10}, {4, -4}, {-2, -3}, {0, -3.6}, {2, -3.1}, {-4, -4}, {10, 10}});
    EXPECT_EQ(test::points_left(test::trim("3r", curve)),
              (std::vector<SectionPoint>{{-10, 10}, {0, 0}, {10, 10}}));
}

TEST(TrimRepaired, IgnoresTheOptions)
{
    const SectionCurve wave =
        test::open_curve({{-4, 2}, {-2, 0}, {0, 1}, {2, 0}, {4, 2}});
    EXPECT_EQ(test::points_left(test::trim(
                  "3r", wave,
                  {.detection = FoldDetection::Literal, .search = BranchSearch::Scan})),
              wave.points);
}

}  // namespace
}  // namespace endmill
