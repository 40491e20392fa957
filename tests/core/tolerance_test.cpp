// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/tolerance.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/vec.h"
#include "random.h"

namespace endmill {
namespace {

TEST(Tolerance, OfUnitVectorsHoldsAfterNormalising)
{
    test::Random random{17};
    for (int k = 0; k < 10'000; ++k) {
        const Vec3 axis =
            Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.01, 1)}
                .normalized();
        EXPECT_LE(std::abs(axis.norm() - 1), unit_vector_rounding);
    }
}

TEST(Tolerance, OfAnAxisInAFileAllowsFourDecimals)
{
    test::Random random{19};
    for (int k = 0; k < 10'000; ++k) {
        Vec3 axis =
            Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.01, 1)}
                .normalized();
        for (double& component : axis)
            component = std::round(component * 1e4) / 1e4;
        EXPECT_LE(std::abs(axis.norm() - 1), axis_length_tolerance);
    }
}

TEST(Tolerance, OfUprightAxesAllowsSixDecimalsForForcesOnly)
{
    test::Random random{23};
    constexpr double half_a_digit = 5e-7;
    double largest = 0;
    for (int k = 0; k < 10'000; ++k) {
        const Vec3 rounding{random.uniform(-half_a_digit, half_a_digit),
                            random.uniform(-half_a_digit, half_a_digit),
                            random.uniform(-half_a_digit, half_a_digit)};
        EXPECT_LE(rounding.norm(), cutting_axis_tolerance);
        largest = std::max(largest, rounding.norm());
    }
    EXPECT_GT(largest, removal_axis_tolerance);
}

TEST(Tolerance, IsAboveTheRoundingOfDoubles)
{
    constexpr double unit_roundoff = std::numeric_limits<double>::epsilon();
    for (const double tolerance :
         {unit_vector_rounding, level_normal, thinnest_angle, same_point_share,
          vanishing_partial_share, least_grid_interval, box_margin_share,
          radius_rounding_share, turn_tolerance, equal_angles, smooth_angle,
          removal_axis_tolerance, cutting_axis_tolerance})
        EXPECT_GE(tolerance, 1000 * unit_roundoff);
}

}  // namespace
}  // namespace endmill
