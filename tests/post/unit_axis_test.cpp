// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/unit_axis.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

TEST(UnitAxis, OfADoubleUnitVectorIsThatVectorToTheBit)
{
    test::Random random{5};
    for (int k = 0; k < 1000; ++k) {
        const Vec3 axis =
            Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1)}
                .normalized();
        EXPECT_EQ(unit_axis(axis), axis);
    }
}

// An axis whose components are rounded to four decimals must be accepted.
TEST(UnitAxis, OfAVectorOfFourDecimalsIsScaled)
{
    test::Random random{6};
    for (int k = 0; k < 1000; ++k) {
        const Vec3 axis =
            Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}
                .normalized();
        const Vec3 rounded = (axis * 1e4).array().round() / 1e4;
        const auto unit = unit_axis(rounded);
        ASSERT_TRUE(unit) << rounded.transpose();
        EXPECT_NEAR(unit->norm(), 1, 1e-15);
        EXPECT_LT((*unit - axis).norm(), 2e-4);
    }
}

TEST(UnitAxis, IsEmptyForOtherLengths)
{
    for (const Vec3& axis :
         {Vec3{0, 0, 0}, Vec3{0, 0, 1.0002}, Vec3{0, 0, 0.9998}, Vec3{1, 1, 1},
          Vec3{0, 0, std::numeric_limits<double>::quiet_NaN()}, Vec3{1e200, 1e200, 0}})
        EXPECT_FALSE(unit_axis(axis)) << axis.transpose();
}

}  // namespace
}  // namespace endmill
