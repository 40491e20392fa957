// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/section_views.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/trimming/detail/profile_families.h"
#include "endmill/trimming/trimming_quality.h"
#include "trimmed_curves.h"

namespace endmill {
namespace {

std::vector<SectionCurve> hard_curves()
{
    std::vector<SectionCurve> curves;
    for (const OffsetProfile& profile : hard_profiles())
        curves.push_back(offset_curve(profile, 101));
    return curves;
}

bool is_inside(const SectionPoint& point, const SectionPoint& centre, double half_width)
{
    return std::abs(point.x() - centre.x()) <= half_width &&
           std::abs(point.y() - centre.y()) <= half_width;
}

// Number of segments with both ends in the window. A stretch of n points has n - 1 of
// them.
std::size_t segments_inside(std::span<const SectionCurve> curves,
                            const SectionPoint& centre, double half_width)
{
    std::size_t count = 0;
    for (const SectionCurve& curve : curves)
        for (std::size_t i = 1; i < curve.points.size(); ++i)
            count += is_inside(curve.points[i - 1], centre, half_width) &&
                             is_inside(curve.points[i], centre, half_width)
                         ? 1
                         : 0;
    return count;
}

TEST(CurvesNear, KeepTheSegmentsInsideTheWindow)
{
    const auto curves = hard_curves();
    const SectionPoint centre = curves[2].points[50];
    for (const double half_width : {0.1, 1.0, 3.0, 100.0}) {
        const auto near = curves_near(curves, centre, half_width);
        EXPECT_EQ(point_count(near) - near.size(),
                  segments_inside(curves, centre, half_width));
        for (const SectionCurve& stretch : near) {
            EXPECT_GE(stretch.points.size(), 2U);
            for (const SectionPoint& point : stretch.points)
                EXPECT_TRUE(is_inside(point, centre, half_width));
        }
    }
}

TEST(CurvesNear, AreTheSameForTheSameCurvesAsAResult)
{
    const auto curves = hard_curves();
    const SectionPoint centre = curves[2].points[50];
    const auto sections = curves_near(curves, centre, 2);
    const auto trimmed = curves_near(untrimmed(curves).curves, centre, 2);
    ASSERT_EQ(sections.size(), trimmed.size());
    for (std::size_t k = 0; k < sections.size(); ++k) {
        ASSERT_EQ(sections[k].points.size(), trimmed[k].points.size());
        for (std::size_t i = 0; i < sections[k].points.size(); ++i)
            EXPECT_EQ(sections[k].points[i], trimmed[k].points[i].at);
    }
}

TEST(CurvesNear, AreNoneInAnEmptyWindow)
{
    EXPECT_TRUE(curves_near(hard_curves(), {1e6, 0}, 1).empty());
}

TEST(Untrimmed, HasNothingCutOutAndIsAsDeepAsItsLoops)
{
    const std::vector curves{
        test::open_curve({{-6, 6}, {2, -2}, {0, -1}, {-2, -2}, {6, 6}})};
    const Trimmed result = untrimmed(curves);
    EXPECT_TRUE(cut_out(curves, result).empty());
    EXPECT_EQ(point_count(result.curves), point_count(curves));
    // At the vertex (2, -2) the envelope is 4 mm above, and the flatter segment falls by
    // 1 in 2.
    EXPECT_NEAR(trimming_quality(curves, result).gouge_mm, 4 * 2 / std::sqrt(5), 1e-12);
}

TEST(MeanPlace, IgnoresCutsWithoutAPlace)
{
    const std::vector<CutOut> cuts{{0, 1, 2, CutCause::Fold, SectionPoint{1, 5}, ""},
                                   {0, 3, 4, CutCause::Closed, std::nullopt, ""},
                                   {1, 1, 2, CutCause::End, SectionPoint{4, -1}, ""}};
    EXPECT_EQ(mean_place(cuts), SectionPoint(2.5, 2));
    EXPECT_FALSE(mean_place(std::span{cuts}.subspan(1, 1)));
    EXPECT_FALSE(mean_place({}));
}

TEST(LinesInSpace, HaveTheCoordinatesOfTheirSections)
{
    const auto curves = hard_curves();
    const DriveFrame frame{Angle::degrees(25)};
    const auto lines = lines_in_space(untrimmed(curves).curves, frame, -7);
    ASSERT_EQ(lines.size(), curves.size());
    for (std::size_t k = 0; k < lines.size(); ++k) {
        ASSERT_EQ(lines[k].size(), curves[k].points.size());
        for (std::size_t i = 0; i < lines[k].size(); ++i) {
            EXPECT_NEAR(frame.along(lines[k][i]), curves[k].points[i].x(), 1e-12);
            EXPECT_NEAR(frame.across(lines[k][i]), -7, 1e-12);
            EXPECT_EQ(lines[k][i].z(), curves[k].points[i].y());
        }
    }
}

}  // namespace
}  // namespace endmill
