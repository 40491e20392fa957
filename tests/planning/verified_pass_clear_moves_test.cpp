// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/verified_pass.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr double radius = 5;
constexpr double tolerance = 0.2;

ClearMoves over(const Surface& part)
{
    const double side = 1;
    return {{&part, 1}, {&side, 1}, BallCutter{radius}, Vec3::UnitZ(), tolerance};
}

TEST(ClearMoves, AreClearAboveThePart)
{
    const Surface part = test::plane(40, 30);
    const ClearMoves clear = over(part);
    FinerPieces finer;
    const auto holds_at = [&](double height) {
        return clear.is_clear({{10, 15, height}, {30, 15, height}}, finer);
    };
    EXPECT_TRUE(holds_at(radius));
    EXPECT_TRUE(holds_at(radius - 0.99 * tolerance));
    EXPECT_FALSE(holds_at(radius - 1.01 * tolerance));
    EXPECT_EQ(clear.tolerance(), tolerance);
    EXPECT_EQ(clear.cutter().radius(), radius);
}

// Beside the edge the ball cuts deeper along the normal than any point of the plane lies
// in it.
TEST(ClearMoves, AreLimitedBesideTheEdgeByTheDepthAlongTheNormal)
{
    const Surface part = test::plane(40, 30);
    const ClearMoves clear = over(part);
    FinerPieces finer;
    const double beyond = 3;
    const double touching = std::sqrt(radius * radius - beyond * beyond);
    const auto holds_at = [&](double taken) {
        const Vec3 centre{-beyond, 15, touching - taken};
        return clear.is_clear({centre, centre}, finer);
    };
    EXPECT_TRUE(holds_at(0.98 * border_share * tolerance));
    EXPECT_FALSE(holds_at(1.02 * border_share * tolerance));
}

TEST(ClearMoves, RefuseTolerancesOutOfRange)
{
    const Surface part = test::plane(40, 30);
    const double side = 1;
    for (const double bad : {0.0, -1.0, 2 * radius})
        EXPECT_THROW(
            (ClearMoves{{&part, 1}, {&side, 1}, BallCutter{radius}, Vec3::UnitZ(), bad}),
            DomainError);
}

}  // namespace
}  // namespace endmill
