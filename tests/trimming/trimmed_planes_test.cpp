// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/trimmed_planes.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/trimming/cut_out.h"
#include "trimmed_curves.h"

namespace endmill {
namespace {

// Vector T1 of docs/methods/interference.md, section 11: one symmetric loop that is
// cut at (0, 0).
PlaneSection looped()
{
    PlaneSection section;
    section.curves = {{{{-6, 6}, {2, -2}, {0, -1}, {-2, -2}, {6, 6}}, false}};
    return section;
}

using Points = std::vector<SectionPoint>;

TEST(TrimmedPlanes, TrimEveryPlane)
{
    const std::vector<PlaneSection> planes{looped(), PlaneSection{}, looped()};
    const auto trimmed = trim_planes(planes, {}, test::trimming_method("envelope"), {});
    ASSERT_EQ(trimmed.size(), 3U);
    EXPECT_EQ(test::places(trimmed[0].curves[0]), (Points{{-6, 6}, {0, 0}, {6, 6}}));
    EXPECT_TRUE(trimmed[1].curves.empty());
    EXPECT_EQ(test::places(trimmed[2].curves[0]), test::places(trimmed[0].curves[0]));
}

TEST(TrimmedPlanes, AreCutOffAtTheEndsOfTheirRanges)
{
    const std::vector<PlaneSection> planes{looped(), looped()};
    const std::vector<std::optional<Interval>> ranges{Interval{-1, 5}, std::nullopt};
    const auto trimmed = trim_planes(planes, ranges, test::trimming_method("3r"), {});
    EXPECT_EQ(test::places(trimmed[0].curves[0]), (Points{{-1, 1}, {0, 0}, {5, 5}}));
    EXPECT_TRUE(trimmed[1].curves.empty());
}

// A stretch cut by the range alone has the range's rule; one cut by both has the last
// rule.
TEST(TrimmedPlanes, NameTheRuleOfTheRange)
{
    std::vector<PlaneSection> planes{looped()};
    auto& points = planes[0].curves[0].points;
    points.insert(points.begin() + 1, {-3, 3});
    points.insert(points.end() - 1, {3, 3});
    const std::vector<std::optional<Interval>> ranges{Interval{-4, 5}};
    for (const char* name : {"3r", "envelope", "winding"}) {
        const TrimmingMethod& method = test::trimming_method(name);
        const auto trimmed = trim_planes(planes, ranges, method, {});
        const auto cuts = cut_out(planes[0].curves, trimmed[0]);
        ASSERT_EQ(cuts.size(), 3U);
        EXPECT_EQ(cuts[0].rule, "outside the range");
        EXPECT_EQ(cuts[1].rule, name == std::string_view{"3r"}
                                    ? "valley"
                                    : trim_planes(planes, {}, method, {})[0].rule);
        EXPECT_EQ(cuts[2].rule, "outside the range");
    }
    const std::vector<std::optional<Interval>> none{std::nullopt};
    const auto nothing = trim_planes(planes, none, test::trimming_method("3r"), {});
    const auto cuts = cut_out(planes[0].curves, nothing[0]);
    ASSERT_EQ(cuts.size(), 1U);
    EXPECT_EQ(cuts[0].rule, "outside the range");
}

// Folds without a crossing at s of 2 to 3 and of 6 to 7, which method 3r leaves.
TEST(TrimmedPlanes, CountTheFoldsThatTheRangeLeaves)
{
    std::vector<PlaneSection> planes(1);
    planes[0].curves = {{{{0, 0}, {3, 3}, {2, 4}, {7, 5}, {6, 6}, {10, 7}}, false}};
    const auto unresolved = [&](const std::optional<Interval>& range) {
        const std::vector<std::optional<Interval>> ranges{range};
        return trim_planes(planes, ranges, test::trimming_method("3r"), {})[0].unresolved;
    };
    EXPECT_EQ(unresolved(Interval{0, 10}), 2);
    EXPECT_EQ(unresolved(Interval{4, 10}), 1);
    EXPECT_EQ(unresolved(Interval{0, 6.5}), 2);  // a part of the second fold
    EXPECT_EQ(unresolved(Interval{3, 6}), 0);
    EXPECT_EQ(unresolved(Interval{0, 2}), 0);
    EXPECT_EQ(unresolved(std::nullopt), 0);
}

TEST(TrimmedPlanes, NeedARangeForEachPlaneOrNone)
{
    const std::vector<PlaneSection> planes{looped(), looped()};
    const std::vector<std::optional<Interval>> one{Interval{0, 1}};
    EXPECT_THROW(trim_planes(planes, one, test::trimming_method("envelope"), {}),
                 DomainError);
}

// Nothing is cut out of sections that keep every vertex.
TEST(UntrimmedPlanes, KeepEveryVertex)
{
    std::vector<PlaneSection> planes{looped(), PlaneSection{}, looped()};
    planes[2].curves.push_back({{{8, 0}, {9, 1}, {9, -1}, {8, 0}}, true});
    const std::vector<Trimmed> kept = untrimmed_planes(planes);
    ASSERT_EQ(kept.size(), 3U);
    for (std::size_t k = 0; k < planes.size(); ++k) {
        ASSERT_EQ(kept[k].curves.size(), planes[k].curves.size());
        for (std::size_t c = 0; c < planes[k].curves.size(); ++c) {
            EXPECT_EQ(test::places(kept[k].curves[c]), planes[k].curves[c].points);
            EXPECT_EQ(kept[k].curves[c].is_closed, planes[k].curves[c].is_closed);
        }
        EXPECT_TRUE(cut_out(planes[k].curves, kept[k]).empty());
    }
}

TEST(SectionHeight, IsTheExtentOfAllCurvesInZ)
{
    std::vector<PlaneSection> planes{looped(), looped()};
    EXPECT_EQ(section_height(planes), 8);  // from -2 to 6
    planes[1].curves[0].points.push_back({7, 11});
    EXPECT_EQ(section_height(planes), 13);
    EXPECT_EQ(section_height({}), 0);
    EXPECT_EQ(section_height(std::vector{PlaneSection{}}), 0);
}

// The frame of the planes leads back to s, t and z of each point.
TEST(SectionPoints, LieInTheirPlanes)
{
    const DrivePlanes planes{DriveFrame{Angle::degrees(20)}, {-3, 4}};
    const std::vector<PlaneSection> sections{looped(), looped()};
    const std::vector<Trimmed> kept = untrimmed_planes(sections);
    const std::vector<Vec3> points = section_points(planes, kept);
    ASSERT_EQ(points.size(), 10U);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const SectionPoint& at = sections[0].curves[0].points[i % 5];
        EXPECT_NEAR(planes.frame.along(points[i]), at.x(), 1e-14);
        EXPECT_NEAR(planes.frame.across(points[i]), planes.positions[i / 5], 1e-14);
        EXPECT_EQ(points[i].z(), at.y());
    }
    EXPECT_THROW(section_points(planes, std::span{kept}.first(1)), DomainError);
}

}  // namespace
}  // namespace endmill
