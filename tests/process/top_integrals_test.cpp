// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/top_integrals.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace endmill {
namespace {

using std::numbers::pi;

CoefficientSums sums_of_top(const EngagedRegion& region)
{
    return top_integrals(region, ChipModel::Paper,
                         region.ranges_at(region.top_sine, region.top_cosine));
}

// 2 pi I6 of a slot is pi - 2 lambda (docs/methods/ball-end-milling.md, section 9,
// A7): the top contributes pi and the front -2 lambda.
TEST(TopIntegrals, OfASlotAddUpToItsArea)
{
    for (const double lambda : {-0.8, -0.2, 0.3, 1.1}) {
        const EngagedRegion region{{0, lambda, 0, 1, PreviousPass::None}};
        const double front = border_integrals(region, ChipModel::Paper, 1e-12)[5];
        EXPECT_NEAR(sums_of_top(region)[5], pi, 1e-12);
        EXPECT_NEAR(front, -2 * lambda, 1e-11);
    }
}

TEST(TopIntegrals, OfALevelSlotAreThoseOfTheTop)
{
    const EngagedRegion region{{0, 0, 0, 0.5, PreviousPass::None}};
    for (const double sum : border_integrals(region, ChipModel::Exact, 1e-12))
        EXPECT_EQ(sum, 0);
    const CoefficientSums top = sums_of_top(region);
    EXPECT_NEAR(top[3], 1, 1e-12);  // height times the mean of sin over half a turn
    EXPECT_NEAR(top[5], pi / 2, 1e-12);
    EXPECT_NEAR(top[7], pi / 2 * (pi / 3 - std::sin(2 * pi / 3) / 2), 1e-12);
}

}  // namespace
}  // namespace endmill
