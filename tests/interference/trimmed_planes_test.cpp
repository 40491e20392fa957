// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/interference/trimmed_planes.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "trimmed_curves.h"

namespace endmill {
namespace {

// Spec of interference, vector T1: one symmetric loop, cut at (0, 0).
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

TEST(TrimmedPlanes, NeedARangeForEachPlaneOrNone)
{
    const std::vector<PlaneSection> planes{looped(), looped()};
    const std::vector<std::optional<Interval>> one{Interval{0, 1}};
    EXPECT_THROW(trim_planes(planes, one, test::trimming_method("envelope"), {}),
                 DomainError);
}

}  // namespace
}  // namespace endmill
