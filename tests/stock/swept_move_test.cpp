// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/swept_move.h"

#include <gtest/gtest.h>

#include "small_moves.h"

namespace endmill {
namespace {

TEST(SweptMove, HasTheComponentsOfTheMove)
{
    for (const test::SmallMove& move : test::small_moves(1, 200)) {
        const SweptMove swept = move.swept();
        const Vec3 end{swept.x + swept.length * swept.direction_x,
                       swept.y + swept.length * swept.direction_y, swept.z + swept.rise};
        if (swept.length > 0) {
            EXPECT_LT((end - move.to).norm(), 1e-13);
            EXPECT_NEAR(swept.slope * swept.length, swept.rise, 1e-13);
        }
    }
}

TEST(SweptMove, AnUprightMoveStandsAtItsLowerEnd)
{
    for (const double z : {-4.0, 9.0}) {
        const SweptMove swept = swept_move({1, 2, z}, {1, 2, 3});
        EXPECT_EQ(swept.z, std::min(z, 3.0));
        EXPECT_EQ(swept.rise, 0);
        EXPECT_EQ(swept.length, 0);
        EXPECT_EQ(swept.slope, 0);
    }
}

}  // namespace
}  // namespace endmill
