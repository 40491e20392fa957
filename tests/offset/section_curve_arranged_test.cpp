// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/offset/section_curve.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

using Points = std::vector<SectionPoint>;

TEST(CurveArrangement, TurnsAnOpenCurveTowardsRisingS)
{
    const auto ordered = arranged({{{{3, 0}, {-1, 2}, {0, 5}}, false}});
    EXPECT_EQ(ordered[0].points, (Points{{0, 5}, {-1, 2}, {3, 0}}));
}

TEST(CurveArrangement, KeepsAnOpenCurveWhoseEndsLieAboveEachOther)
{
    const Points points{{1, 4}, {2, 0}, {1, -4}};
    EXPECT_EQ(arranged({{points, false}})[0].points, points);
}

TEST(CurveArrangement, BeginsAClosedCurveWhereSThenZIsLeast)
{
    const auto ordered = arranged({{{{2, 0}, {2, 2}, {0, 2}, {0, 0}, {2, 0}}, true}});
    EXPECT_EQ(ordered[0].points, (Points{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}}));
    EXPECT_TRUE(ordered[0].is_closed);
}

TEST(CurveArrangement, NumbersCurvesByLeastSThenZ)
{
    const SectionCurve late{{{5, 0}, {9, 0}}, false};
    const SectionCurve upper{{{1, 7}, {2, 7}}, false};
    // its smallest s is inside
    const SectionCurve bulging{{{2, 3}, {1, 2}, {4, 4}}, false};
    const auto ordered = arranged({late, upper, bulging});
    EXPECT_EQ(ordered[0].points, bulging.points);
    EXPECT_EQ(ordered[1].points, upper.points);
    EXPECT_EQ(ordered[2].points, late.points);
}

TEST(CurveArrangement, WithoutCurvesIsEmpty)
{
    EXPECT_TRUE(arranged({}).empty());
}

}  // namespace
}  // namespace endmill
