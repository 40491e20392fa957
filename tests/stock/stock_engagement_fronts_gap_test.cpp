// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/stock_engagement.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

const Block cube{{0, 0, 0}, {10, 10, 10}};
const Cutter ball = Cutter::ball(3);

ToolPath move(const Vec3& from, const Vec3& to)
{
    return {{{0, 0, Move::Plunge, 0, {from, Vec3::UnitZ()}},
             {0, 1, Move::Cut, 0, {to, Vec3::UnitZ()}}}};
}

double gap(const Vec3& from, const Vec3& to)
{
    const std::array<std::size_t, 1> points{1};
    return stock_gap(move(from, to), points, ball, cube);
}

TEST(StockGap, IsTheDistanceOfTheNearestFaceEdgeOrCornerLessTheRadius)
{
    EXPECT_NEAR(gap({-20, 5, 0}, {-9, 5, 0}), 9 - 3, 1e-9);
    EXPECT_NEAR(gap({-50, 14, 0}, {70, 14, 0}), 4 - 3, 1e-5);
    EXPECT_NEAR(gap({0, 5, 12}, {9, 5, 17}), 2, 1e-9);
    // The line x + y = 30 passes the corner (10, 10) at a distance of 10/sqrt(2).
    EXPECT_NEAR(gap({30, 0, 0}, {0, 30, 0}), 10 / std::sqrt(2.0) - 3, 1e-5);
}

// The shank extends upwards from the ball, so a cutter below the block meets it.
TEST(StockGap, IsNoneWhereTheCutterMeetsTheBlock)
{
    EXPECT_EQ(gap({-20, 5, 5}, {40, 5, 5}), 0);
    EXPECT_EQ(gap({-20, 5, -90}, {40, 5, -90}), 0);
    EXPECT_EQ(gap({5, 5, 0}, {5, 5, 0}), 0);
    EXPECT_EQ(stock_gap(ToolPath{}, std::vector<std::size_t>{}, ball, cube),
              std::numeric_limits<double>::infinity());
}

TEST(StockGap, RefusesOtherCuttersAndPoints)
{
    const ToolPath path = move({0, 0, 0}, {1, 0, 0});
    const std::array<std::size_t, 1> one{1};
    const std::array<std::size_t, 1> first{0};
    const std::array<std::size_t, 1> beyond{2};
    EXPECT_THROW(stock_gap(path, one, Cutter::flat(3), cube), DomainError);
    EXPECT_THROW(stock_gap(path, first, ball, cube), DomainError);
    EXPECT_THROW(stock_gap(path, beyond, ball, cube), DomainError);
}

}  // namespace
}  // namespace endmill
