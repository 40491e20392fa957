// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/offset/section_curve.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(SectionCurve, IsOpenByDefault)
{
    EXPECT_FALSE(SectionCurve{}.is_closed);
    EXPECT_TRUE(SectionCurve{}.points.empty());
}

}  // namespace
}  // namespace endmill
