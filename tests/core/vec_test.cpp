// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/vec.h"

#include <array>

#include <gtest/gtest.h>

namespace endmill {
namespace {

static_assert(sizeof(Vec3) == 3 * sizeof(double), "nets of points are arrays of doubles");

TEST(Vec3, HoldsXYZInThisOrder)
{
    const std::array<Vec3, 2> points{Vec3{1, 2, 3}, Vec3{4, 5, 6}};
    for (int k = 0; k < 6; ++k)
        EXPECT_EQ(points[0].data()[k], k + 1);
    EXPECT_EQ(points[1].y(), 5);
}

TEST(Vec3, HasTheLengthThatPythagorasGivesIt)
{
    EXPECT_EQ(Vec3(2, 3, 6).norm(), 7);
    EXPECT_EQ(Vec3::UnitZ().dot(Vec3{1, 2, 3}), 3);
}

}  // namespace
}  // namespace endmill
