// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/triangle_contact.h"

#include <gtest/gtest.h>

#include "endmill/core/tolerance.h"

namespace endmill {
namespace {

TEST(TriangleContact, IsNoneUnlessFound)
{
    EXPECT_LT(TriangleContact{}.tip_z, std::numeric_limits<double>::lowest());
}

// TriangleDrop promises 1e-9 mm.
TEST(TriangleContact, LeavesMostOfThePromisedAccuracyToTheFormulas)
{
    EXPECT_DOUBLE_EQ(5 * tip_accuracy, 1e-9);
}

}  // namespace
}  // namespace endmill
