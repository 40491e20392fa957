// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/envelope_trimming.h"

#include <gtest/gtest.h>

#include "trimmed_curves.h"

namespace endmill {
namespace {

TEST(EnvelopeHeight, IsTheHighestOfAllCurves)
{
    const std::vector curves{test::open_curve({{0, 0}, {4, 4}}),
                             test::open_curve({{0, 3}, {4, 1}})};
    const EnvelopeHeight height{curves};
    EXPECT_DOUBLE_EQ(height.at(0).value(), 3);
    EXPECT_DOUBLE_EQ(height.at(1).value(), 2.5);
    EXPECT_DOUBLE_EQ(height.at(2).value(), 2);
    EXPECT_DOUBLE_EQ(height.at(3.5).value(), 3.5);
    EXPECT_DOUBLE_EQ(height.at(4).value(), 4);
}

TEST(EnvelopeHeight, IsTheUpperEndOfAVerticalStep)
{
    const SectionCurve step = test::open_curve({{0, 0}, {2, 0}, {2, 5}, {3, 5}});
    const EnvelopeHeight height{{&step, 1}};
    EXPECT_EQ(height.at(2), 5);
    EXPECT_EQ(height.at(1), 0);
}

TEST(EnvelopeHeight, IsEmptyWithoutACurve)
{
    const std::vector curves{test::open_curve({{0, 0}, {1, 1}}),
                             test::open_curve({{3, 0}, {4, 1}})};
    const EnvelopeHeight height{curves};
    for (const double s : {-1.0, 2.0, 5.0})
        EXPECT_FALSE(height.at(s));
    EXPECT_FALSE(EnvelopeHeight{{}}.at(0));
}

}  // namespace
}  // namespace endmill
