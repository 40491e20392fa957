// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/closed_sections.h"

#include <gtest/gtest.h>

#include "trimmed_curves.h"

namespace endmill {
namespace {

const SectionCurve open = test::open_curve({{-9, 5}, {-1, 0}, {1, 0}, {9, 5}});

SectionCurve crescent(double height)
{
    return {
        {{-1, height}, {0, height + 0.5}, {1, height}, {0, height + 0.25}, {-1, height}},
        true};
}

TEST(TrimClosed, DropsACrescentBelowTheOpenCurves)
{
    const std::vector<SectionCurve> curves{open, crescent(-3)};
    const Trimmed trimmed = trim_closed(curves);
    EXPECT_TRUE(trimmed.curves.empty());
    ASSERT_EQ(trimmed.rules.size(), 1U);
    EXPECT_EQ(trimmed.rules[0].curve, 1);
    EXPECT_EQ(trimmed.rules[0].first_point, 0);
    EXPECT_EQ(trimmed.rules[0].last_point, 4);
    EXPECT_EQ(trimmed.rules[0].rule, "closed");
}

TEST(TrimClosed, KeepsTheTopOfOneThatReachesAbove)
{
    for (const double height : {-0.4, 2.0}) {
        const std::vector<SectionCurve> curves{open, crescent(height)};
        const Trimmed trimmed = trim_closed(curves);
        ASSERT_EQ(trimmed.curves.size(), 1U);
        EXPECT_FALSE(trimmed.curves[0].is_closed);
        const auto& points = trimmed.curves[0].points;
        ASSERT_EQ(points.size(), 3U);
        EXPECT_EQ(points[1].at, SectionPoint(0, height + 0.5));
        EXPECT_EQ(points[1].on, (SegmentNumber{1, 1}));
    }
}

TEST(TrimClosed, TreatsTouchingCurvesAsCovered)
{
    const std::vector<SectionCurve> curves{open, crescent(-0.5)};
    EXPECT_TRUE(trim_closed(curves).curves.empty());
}

TEST(TrimClosed, KeepsOneBesideOrWithoutOpenCurves)
{
    SectionCurve beside = crescent(-3);
    for (SectionPoint& point : beside.points)
        point.x() += 20;
    const std::vector<SectionCurve> curves{open, beside};
    EXPECT_EQ(trim_closed(curves).curves.size(), 1U);
    EXPECT_EQ(trim_closed(curves).rule, "below the envelope");
    EXPECT_EQ(trim_closed({&beside, 1}).curves.size(), 1U);
}

TEST(TrimClosed, IsUsedByTheMethods)
{
    const std::vector<SectionCurve> curves{open, crescent(-3)};
    for (const char* method : {"1", "2", "3", "3r"}) {
        const Trimmed trimmed = test::trimming_method(method).trim(
            curves, test::options_for(open, FoldDetection::Literal));
        ASSERT_EQ(trimmed.curves.size(), 1U);
        EXPECT_EQ(trimmed.curves[0].points[0].on.curve, 0);
        EXPECT_EQ(trimmed.rules.back().rule, "closed");
    }
}

}  // namespace
}  // namespace endmill
