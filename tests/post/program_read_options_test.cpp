// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/program.h"

#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/path/tool_path.h"

namespace endmill {
namespace {

TEST(PointsWithin, LeaveRoomForAVectorThatGrows)
{
    constexpr double gib = 1024.0 * 1024 * 1024;
    const double bytes = 3 * sizeof(PathPoint);
    EXPECT_LE(static_cast<double>(points_within(8)) * bytes, 8 * gib);
    EXPECT_GT(static_cast<double>(points_within(8) + 1) * bytes, 8 * gib);
    EXPECT_EQ(points_within(0), 0U);
}

TEST(PointsWithin, AreAtMostWhatAnIntCounts)
{
    EXPECT_EQ(points_within(1e9), std::size_t{std::numeric_limits<int>::max()});
}

TEST(GcodeReadOptions, AcceptsDefaultsAndRefusesValuesOutOfRange)
{
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_NO_THROW(require_sound(GcodeReadOptions{}));
    EXPECT_THROW(require_sound(GcodeReadOptions{.arc_tolerance_mm = 0}), DomainError);
    EXPECT_THROW(require_sound(GcodeReadOptions{.arc_tolerance_mm = infinity}),
                 DomainError);
    EXPECT_THROW(require_sound(GcodeReadOptions{.programmed_point_height_mm = -1}),
                 DomainError);
    EXPECT_THROW(require_sound(GcodeReadOptions{.programmed_point_height_mm = infinity}),
                 DomainError);
    EXPECT_THROW(require_sound(GcodeReadOptions{.max_extent_mm = 0}), DomainError);
    EXPECT_THROW(require_sound(GcodeReadOptions{.most_points = std::size_t{1} << 31U}),
                 DomainError);
}

}  // namespace
}  // namespace endmill
