// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/deviation_cells.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(DeviationAreas, WeightRemainingStockByAreaAndCountGougesAsZero)
{
    Deviation deviation;
    deviation.left = {0.5F, -3.0F, 0.25F};
    deviation.area = {2.0F, 4.0F, 2.0F};
    add_areas(deviation);
    EXPECT_EQ(deviation.area_mm2, 8);
    EXPECT_EQ(deviation.mean_scallop_mm, 1.5 / 8);
    EXPECT_NEAR(deviation.p99_scallop_mm, 0.5, 0.5e-3);
}

// A hundred cells of equal area: 99 % of the area does not exceed the second highest
// value.
TEST(DeviationAreas, QuantileExcludesOnePercentOfTheArea)
{
    Deviation deviation;
    for (int k = 1; k <= 100; ++k) {
        deviation.left.push_back(0.01F * static_cast<float>(k));
        deviation.area.push_back(1);
    }
    add_areas(deviation);
    EXPECT_NEAR(deviation.p99_scallop_mm, 0.99, 1e-3);
}

TEST(DeviationAreas, WithoutCellsAreZero)
{
    Deviation deviation;
    add_areas(deviation);
    EXPECT_EQ(deviation.area_mm2, 0);
    EXPECT_EQ(deviation.mean_scallop_mm, 0);
    EXPECT_EQ(deviation.p99_scallop_mm, 0);
}

}  // namespace
}  // namespace endmill
