// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/move_bins.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "small_moves.h"

namespace endmill {
namespace {

// 6 by 4 groups of 3.2 mm; the last ones extend beyond the grid.
StockGrid small_grid()
{
    return {.low_x = -9,
            .low_y = -6,
            .pitch = 0.1,
            .columns = 180,
            .rows = 120,
            .bottom_z = 0};
}

std::vector<SweptMove> swept(const std::vector<test::SmallMove>& moves)
{
    std::vector<SweptMove> all;
    for (const test::SmallMove& move : moves)
        all.push_back(move.swept());
    return all;
}

double distance_over_plane(const test::SmallMove& move, double x, double y)
{
    Vec3 way = move.to - move.from;
    way.z() = 0;
    const Vec3 to{x - move.from.x(), y - move.from.y(), 0};
    const double length2 = way.squaredNorm();
    const double share = length2 > 0 ? std::clamp(to.dot(way) / length2, 0.0, 1.0) : 0;
    return (to - share * way).norm();
}

// Every cell within reach of a move lies in a group that lists the move. A group far from
// the move does not list it.
TEST(MoveBins, ContainTheMovesThatPass)
{
    constexpr double reach = 2;
    const StockGrid grid = small_grid();
    const auto moves = test::small_moves(9, 200);
    const MoveBins bins{grid, swept(moves), reach, 1'000'000};
    ASSERT_EQ(bins.moves(), moves.size());
    ASSERT_EQ(bins.group_columns(), 6);
    ASSERT_EQ(bins.group_rows(), 4);
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 6; ++column) {
            const auto over = bins.over(static_cast<std::size_t>(row) * 6 + column);
            EXPECT_TRUE(std::ranges::is_sorted(over));
            for (std::uint32_t k = 0; k < moves.size(); ++k) {
                double nearest = 1e9;
                for (int j = row * 32; j < std::min(120, row * 32 + 32); j += 3)
                    for (int i = column * 32; i < std::min(180, column * 32 + 32); i += 3)
                        nearest = std::min(
                            nearest, distance_over_plane(moves[k], grid.x(i), grid.y(j)));
                const bool is_in = std::ranges::binary_search(over, k);
                if (nearest <= reach) {
                    EXPECT_TRUE(is_in) << k;
                }
                if (nearest > reach + 5) {
                    EXPECT_FALSE(is_in) << k;
                }
            }
        }
}

TEST(MoveBins, StopWhenTheyAreFull)
{
    const auto moves = swept(test::small_moves(10, 200));
    const MoveBins few{small_grid(), moves, 2, 50};
    EXPECT_GT(few.moves(), 1U);
    EXPECT_LT(few.moves(), 50U);
    const MoveBins one{small_grid(), moves, 100, 1};
    EXPECT_EQ(one.moves(), 1U);
    EXPECT_EQ(one.over(23).size(), 1U);
    const MoveBins none{small_grid(), {}, 2, 50};
    EXPECT_EQ(none.moves(), 0U);
    EXPECT_TRUE(none.over(0).empty());
}

TEST(MoveBins, AMoveFarAwayIsInNoBin)
{
    const std::vector<SweptMove> far{swept_move({100, 100, 0}, {101, 100, 0})};
    const MoveBins bins{small_grid(), far, 2, 50};
    EXPECT_EQ(bins.moves(), 1U);
    for (std::size_t group = 0; group < 24; ++group)
        EXPECT_TRUE(bins.over(group).empty());
}

}  // namespace
}  // namespace endmill
