// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/program_frame.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(MovedToFrame, KeepsPointsOfTheSameFrame)
{
    const ProgramFrame frame{{1, 2, 3}, {0.1, 0.2, 0.3}, 17};
    EXPECT_EQ(moved_to_frame({0.1, 0.7, 0.3}, frame, frame), Vec3(0.1, 0.7, 0.3));
}

TEST(MovedToFrame, AddsOffsetsAndTurnsAboutZ)
{
    const ProgramFrame shifted{{10, 0, 0}, {0, 0, 2}, 0};
    EXPECT_EQ(moved_to_frame({1, 2, 3}, shifted, {}), Vec3(11, 2, 5));
    EXPECT_EQ(moved_to_frame({11, 2, 5}, {}, shifted), Vec3(1, 2, 3));
    const ProgramFrame turned{{10, 0, 0}, {1, 0, 0}, 90};
    EXPECT_NEAR((moved_to_frame({1, 0, 3}, turned, {}) - Vec3(10, 2, 3)).norm(), 0,
                1e-14);
}

// There and back is the identity.
TEST(MovedToFrame, IsUndoneByTheOtherDirection)
{
    const ProgramFrame one{{10, -4, 2}, {1, 0.5, 0}, 33};
    const ProgramFrame other{{-3, 7, 0}, {0, 2, 9}, -121.5};
    const Vec3 point{1, 2, 3};
    EXPECT_NEAR(
        (moved_to_frame(moved_to_frame(point, one, other), other, one) - point).norm(), 0,
        1e-13);
}

}  // namespace
}  // namespace endmill
