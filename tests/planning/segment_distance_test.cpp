// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/segment_distance.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(SegmentDistance, IsToTheFootOrToAnEnd)
{
    const Vec3 start{1, 1, 1};
    const Vec3 end{5, 1, 1};
    EXPECT_DOUBLE_EQ(segment_distance({3, 4, 5}, start, end), 5);
    EXPECT_DOUBLE_EQ(segment_distance({-2, 5, 1}, start, end), 5);
    EXPECT_DOUBLE_EQ(segment_distance({8, 1, 5}, start, end), 5);
    EXPECT_EQ(nearest_on_segment({3, 4, 5}, start, end), Vec3(3, 1, 1));
}

TEST(SegmentDistance, OfASegmentOfNoLengthIsToItsPoint)
{
    EXPECT_DOUBLE_EQ(segment_distance({3, 4, 0}, Vec3::Zero(), Vec3::Zero()), 5);
}

}  // namespace
}  // namespace endmill
