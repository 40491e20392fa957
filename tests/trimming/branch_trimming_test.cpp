// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/branch_trimming.h"

#include <gtest/gtest.h>

#include "endmill/trimming/detail/sequence_trimming.h"
#include "trimmed_curves.h"

namespace endmill {
namespace {

const SectionCurve loop = test::open_curve({{-6, 6}, {2, -2}, {0, -1}, {-2, -2}, {6, 6}});
const SectionCurve overhang =
    test::open_curve({{-9, 4}, {-3, 1}, {-4, 1.25}, {-5, 0.5}, {1, -2.5}});

TEST(TrimBranches, SumsUpOverThePlane)
{
    const std::vector<SectionCurve> curves{overhang, loop, overhang};
    const Trimmed trimmed = trim_branches(curves, {march_segments}, {});
    EXPECT_EQ(trimmed.curves.size(), 3U);
    EXPECT_EQ(trimmed.unresolved, 2);
    ASSERT_EQ(trimmed.rules.size(), 1U);
    EXPECT_EQ(trimmed.rules[0].curve, 1);
}

TEST(TrimBranches, UsesTheGivenSearch)
{
    CrossingSearch* none = [](const SectionChain&, const Branches&,
                              const TrimmingOptions&) -> std::optional<ChainCrossing> {
        return std::nullopt;
    };
    const Trimmed trimmed = trim_branches({&loop, 1}, {none}, {});
    EXPECT_EQ(test::points_left(trimmed), loop.points);
    EXPECT_EQ(trimmed.unresolved, 1);
}

TEST(TrimBranches, SortsTheTrimmedCurvesByPlace)
{
    const SectionCurve far = test::open_curve({{20, 0}, {21, 0}});
    const SectionCurve above = test::open_curve({{-9, 9}, {-8, 9}});
    const std::vector<SectionCurve> curves{far, above, overhang};
    const Trimmed trimmed = trim_branches(curves, {march_segments}, {});
    ASSERT_EQ(trimmed.curves.size(), 3U);
    EXPECT_EQ(trimmed.curves[0].points[0].on.curve, 2);
    EXPECT_EQ(trimmed.curves[1].points[0].on.curve, 1);
    EXPECT_EQ(trimmed.curves[2].points[0].on.curve, 0);
}

TEST(TrimBranches, WithoutCurvesIsEmpty)
{
    EXPECT_TRUE(trim_branches({}, {march_segments}, {}).curves.empty());
}

}  // namespace
}  // namespace endmill
