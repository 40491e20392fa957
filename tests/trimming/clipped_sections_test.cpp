// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/clipped_sections.h"

#include <gtest/gtest.h>

#include "trimmed_curves.h"

namespace endmill {
namespace {

TrimmedCurve curve(const std::vector<SectionPoint>& points, bool is_closed = false)
{
    TrimmedCurve made;
    made.is_closed = is_closed;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const SegmentNumber on{0, static_cast<std::int32_t>(k)};
        made.points.push_back({points[k], on, on, TrimmedKind::Vertex});
    }
    return made;
}

using Points = std::vector<SectionPoint>;

TEST(ClippedSections, KeepsCurvesInsideTheRange)
{
    const Points points{{0, 0}, {1, 5}, {4, 1}};
    const auto left = clipped({curve(points)}, {0, 4});
    ASSERT_EQ(left.size(), 1U);
    EXPECT_EQ(test::places(left[0]), points);
    EXPECT_EQ(left[0].points[2].kind, TrimmedKind::Vertex);
}

TEST(ClippedSections, CutsBothEndsOffWithinASegment)
{
    const auto left = clipped({curve({{0, 0}, {4, 4}, {8, 0}})}, {1, 7});
    ASSERT_EQ(left.size(), 1U);
    EXPECT_EQ(test::places(left[0]), (Points{{1, 1}, {4, 4}, {7, 1}}));
    EXPECT_EQ(left[0].points[0].kind, TrimmedKind::End);
    EXPECT_EQ(left[0].points[0].on, (SegmentNumber{0, 0}));
    EXPECT_EQ(left[0].points[2].on, (SegmentNumber{0, 1}));
}

TEST(ClippedSections, CutsASegmentThatSpansTheRangeInEitherDirection)
{
    EXPECT_EQ(test::places(clipped({curve({{0, 0}, {8, 8}})}, {2, 3})[0]),
              (Points{{2, 2}, {3, 3}}));
    EXPECT_EQ(test::places(clipped({curve({{8, 8}, {0, 0}})}, {2, 3})[0]),
              (Points{{3, 3}, {2, 2}}));
}

TEST(ClippedSections, MakesTwoOfACurveThatLeavesAndReturns)
{
    const auto left = clipped({curve({{0, 0}, {4, 2}, {0, 4}})}, {0, 2});
    ASSERT_EQ(left.size(), 2U);
    EXPECT_EQ(test::places(left[0]), (Points{{0, 0}, {2, 1}}));
    EXPECT_EQ(test::places(left[1]), (Points{{2, 3}, {0, 4}}));
}

TEST(ClippedSections, KeepsAVerticalOnTheBorderAndNothingBeyond)
{
    EXPECT_EQ(test::places(clipped({curve({{1, 0}, {2, 0}, {2, 5}, {3, 5}})}, {1, 2})[0]),
              (Points{{1, 0}, {2, 0}, {2, 5}}));
    EXPECT_TRUE(clipped({curve({{3, 0}, {4, 0}})}, {1, 2}).empty());
    // it only touches the range
    EXPECT_TRUE(clipped({curve({{2, 0}, {4, 0}})}, {1, 2}).empty());
}

TEST(ClippedSections, OpensAClosedCurveThatIsCut)
{
    const TrimmedCurve ring = curve({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}, true);
    EXPECT_TRUE(clipped({ring}, {0, 4})[0].is_closed);
    const auto cut = clipped({ring}, {0, 2});
    ASSERT_EQ(cut.size(), 2U);
    EXPECT_FALSE(cut[0].is_closed);
    EXPECT_EQ(test::places(cut[1]), (Points{{2, 4}, {0, 4}, {0, 0}}));
    EXPECT_FALSE(cut[1].is_closed);
}

TEST(ClippedSections, NamesTheSegmentOfACrossing)
{
    TrimmedCurve crossed = curve({{0, 0}, {4, 4}, {8, 0}});
    crossed.points[1] = {{4, 4}, {0, 0}, {0, 7}, TrimmedKind::Crossing};
    crossed.points[2].on = crossed.points[2].across = {0, 8};
    const auto left = clipped({crossed}, {2, 6});
    EXPECT_EQ(left[0].points[0].on, (SegmentNumber{0, 0}));
    EXPECT_EQ(left[0].points[2].on, (SegmentNumber{0, 7}));
}

}  // namespace
}  // namespace endmill
