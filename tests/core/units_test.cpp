// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/detail/units.h"

#include <cstdint>

#include <gtest/gtest.h>

namespace endmill {
namespace {

// A yard of three feet is 0.9144 m by definition, and a foot has twelve inches.
TEST(Units, AgreeWithTheirDefinitions)
{
    EXPECT_DOUBLE_EQ(3 * 12 * mm_per_inch, 0.9144 * mm_per_m);
    EXPECT_EQ(24 * 60 * seconds_per_min, 86400);
    EXPECT_EQ(bytes_per_gib, static_cast<double>(std::uint64_t{1024} * 1024 * 1024));
}

}  // namespace
}  // namespace endmill
