// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/interference/trimmed_planes.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

// Spec of interference, vector T1: one symmetric loop, cut at (0, 0).
PlaneSection looped()
{
    PlaneSection section;
    section.curves = {{{{-6, 6}, {2, -2}, {0, -1}, {-2, -2}, {6, 6}}, false}};
    return section;
}

const TrimmingMethod& method(std::string_view name)
{
    return *std::ranges::find(trimming_methods(), name, &TrimmingMethod::name);
}

std::vector<SectionPoint> places(const TrimmedCurve& curve)
{
    std::vector<SectionPoint> points;
    for (const TrimmedPoint& point : curve.points)
        points.push_back(point.at);
    return points;
}

using Points = std::vector<SectionPoint>;

TEST(TrimmedPlanes, TrimEveryPlane)
{
    const std::vector<PlaneSection> planes{looped(), PlaneSection{}, looped()};
    const auto trimmed = trim_planes(planes, {}, method("envelope"), {});
    ASSERT_EQ(trimmed.size(), 3U);
    EXPECT_EQ(places(trimmed[0].curves[0]), (Points{{-6, 6}, {0, 0}, {6, 6}}));
    EXPECT_TRUE(trimmed[1].curves.empty());
    EXPECT_EQ(places(trimmed[2].curves[0]), places(trimmed[0].curves[0]));
}

TEST(TrimmedPlanes, AreCutOffAtTheEndsOfTheirRanges)
{
    const std::vector<PlaneSection> planes{looped(), looped()};
    const std::vector<std::optional<Interval>> ranges{Interval{-1, 5}, std::nullopt};
    const auto trimmed = trim_planes(planes, ranges, method("3r"), {});
    EXPECT_EQ(places(trimmed[0].curves[0]), (Points{{-1, 1}, {0, 0}, {5, 5}}));
    EXPECT_TRUE(trimmed[1].curves.empty());
}

TEST(TrimmedPlanes, NeedARangeForEachPlaneOrNone)
{
    const std::vector<PlaneSection> planes{looped(), looped()};
    const std::vector<std::optional<Interval>> one{Interval{0, 1}};
    EXPECT_THROW(trim_planes(planes, one, method("envelope"), {}), DomainError);
}

}  // namespace
}  // namespace endmill
