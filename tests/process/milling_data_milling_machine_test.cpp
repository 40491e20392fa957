// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/milling_data.h"

#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

TEST(MachineLimits, AreOptional)
{
    EXPECT_NO_THROW(require_sound(MachineLimits{}));
}

TEST(MachineLimits, AreAboveZeroAndFinite)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (std::optional<double> MachineLimits::*const member :
         {&MachineLimits::max_rpm, &MachineLimits::max_power_w,
          &MachineLimits::max_torque_n_m, &MachineLimits::max_feed_mm_per_min,
          &MachineLimits::acceleration_m_per_s2}) {
        MachineLimits machine;
        machine.*member = 1;
        EXPECT_NO_THROW(require_sound(machine));
        for (const double value : {0.0, -1.0, nan, infinity}) {
            machine.*member = value;
            EXPECT_THROW(require_sound(machine), DomainError);
        }
    }
}

}  // namespace
}  // namespace endmill
