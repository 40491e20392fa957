// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/fixed_axis_ball.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "endmill/stock/detail/ray_on_motion.h"
#include "random.h"

namespace endmill {
namespace {

constexpr double radius = 3;
const Block block{{-10, -9, -8}, {10, 11, 12}};
const CuttingBody ball_body{Cutter::ball(radius)};

ToolPiece piece_of(const Vec3& from, const Vec3& to, const Vec3& axis)
{
    return {ToolMotion{{from, axis}, {to, axis}}, ball_body, 0, 0};
}

// A fixed-axis move along one of the six directions, and rays of one field. Some moves run
// along the rays, along the axis, or stand.
struct RandomMove {
    RandomMove(test::Random& random, int number)
        : axis{(number % 2 == 0 ? 1.0 : -1.0) * Vec3::Unit(number / 2 % 3)},
          field{number / 6 % 3}
    {
        const auto place = [&](double size) {
            return Vec3{random.uniform(-size, size), random.uniform(-size, size),
                        random.uniform(-size, size)};
        };
        from = place(6);
        const int kind = number / 18 % 5;
        Vec3 way = place(3);
        if (kind == 1)
            way = random.uniform(-3, 3) * Vec3::Unit(field);
        else if (kind == 2)
            way = random.uniform(-3, 3) * axis;
        else if (kind == 3)
            way = Vec3::Zero();
        else if (kind == 4)
            way -= way.dot(axis) * axis;
        to = from + way;
        for (double& column : columns)
            column = random.uniform(-9, 9);
        std::ranges::sort(columns);
        for (double& row : rows)
            row = random.uniform(-9, 9);
        std::ranges::sort(rows);
    }

    Vec3 start(std::size_t column, std::size_t row) const
    {
        Vec3 place = block.low;
        place[(field + 1) % 3] = columns[column];
        place[(field + 2) % 3] = rows[row];
        return place;
    }

    Vec3 axis;
    int field;
    Vec3 from = {};
    Vec3 to = {};
    Eight columns{};
    Eight rows{};
};

template <typename Check>
void for_random_moves(const Check& check)
{
    test::Random random{5};
    const DexelStock stock{block, 1};
    for (int number = 0; number < 900; ++number) {
        const RandomMove move{random, number};
        const ToolPiece piece = piece_of(move.from, move.to, move.axis);
        const auto ball = fixed_axis_ball(piece);
        ASSERT_TRUE(ball);
        check(move, piece, FixedAxisBallOnField{*ball, move.field, stock}, stock);
    }
}

// The least signed distance from a piece on a ray, found by halving: it is convex.
double least_distance(const RayOnMotion& on, double length)
{
    double low = 0;
    double high = length;
    for (int step = 0; step < 100; ++step) {
        const double first = low + (high - low) / 3;
        const double second = high - (high - low) / 3;
        (on.distance(first).least.value < on.distance(second).least.value ? high : low) =
            on.distance(first).least.value < on.distance(second).least.value ? second
                                                                             : first;
    }
    return on.distance((low + high) / 2).least.value;
}

// The expected ends are where the least signed distance over all poses changes its sign.
TEST(FixedAxisBall, ChordsEndWhereTheDistanceIsZero)
{
    int found = 0;
    int missed = 0;
    for_random_moves([&](const RandomMove& move, const ToolPiece& piece,
                         const FixedAxisBallOnField& ball, const DexelStock& stock) {
        std::array<EightWholeChords, 8> chords{};
        ball.find_chords(move.columns, move.rows, chords);
        const double unit = stock.unit();
        const std::int32_t whole = stock.units(move.field);
        for (std::size_t ray = 0; ray < 64; ++ray) {
            const auto& [may, sure, is_grazing] = chords[ray / 8];
            const std::size_t i = ray % 8;
            const RayOnMotion on{move.start(i, ray / 8), Vec3::Unit(move.field),
                                 piece.motion, ball_body};
            const auto distance = [&](std::int32_t at) {
                return on.distance(at * unit).least.value;
            };
            if (is_grazing[i] == 1) {
                EXPECT_NEAR(least_distance(on, whole * unit), 0, 0.02);
                continue;
            }
            if (may.from[i] >= may.to[i]) {
                ++missed;
                EXPECT_GT(least_distance(on, whole * unit), -1e-9);
                continue;
            }
            ++found;
            ASSERT_LE(may.from[i], sure.from[i]);
            ASSERT_LE(sure.to[i], may.to[i]);
            EXPECT_LE(sure.from[i] - may.from[i], 2);
            EXPECT_LE(may.to[i] - sure.to[i], 2);
            if (may.from[i] > 0) {
                EXPECT_GT(distance(may.from[i]), 0);
            }
            if (may.to[i] < whole) {
                EXPECT_GT(distance(may.to[i]), 0);
            }
            if (sure.from[i] < sure.to[i]) {
                EXPECT_LE(distance(sure.from[i]), 0);
                EXPECT_LE(distance(sure.to[i]), 0);
            }
        }
    });
    EXPECT_GT(found, 5000);
    EXPECT_GT(missed, 5000);
}

TEST(FixedAxisBall, BoundsContainTheChords)
{
    for_random_moves([&](const RandomMove& move, const ToolPiece&,
                         const FixedAxisBallOnField& ball, const DexelStock&) {
        std::array<EightWholeChords, 8> chords{};
        ball.find_chords(move.columns, move.rows, chords);
        const DexelInterval bound = ball.bound({{move.columns.front(), move.rows.front()},
                                                {move.columns.back(), move.rows.back()}});
        for (const EightWholeChords& row : chords)
            for (std::size_t i = 0; i < 8; ++i) {
                if (row.may.from[i] >= row.may.to[i])
                    continue;
                EXPECT_LE(bound.from, row.may.from[i]);
                EXPECT_GE(bound.to, row.may.to[i]);
            }
        if (bound.from < bound.to) {
            EXPECT_LE(ball.whole_bound().from, bound.from);
            EXPECT_GE(ball.whole_bound().to, bound.to);
        }
    });
}

TEST(FixedAxisBall, HeightsDoNotCountAboveTheBall)
{
    int compared = 0;
    for_random_moves([&](RandomMove move, const ToolPiece&,
                         const FixedAxisBallOnField& ball, const DexelStock&) {
        if (ball.is_along_axis())
            return;
        Eight& heights = ball.height() == 0 ? move.columns : move.rows;
        const Eight& beside = ball.height() == 0 ? move.rows : move.columns;
        for (double& height : heights)
            height += 20 * move.axis.sum();
        ASSERT_TRUE(ball.is_above({{move.columns.front(), move.rows.front()},
                                   {move.columns.back(), move.rows.back()}}));
        std::array<EightWholeChords, 8> chords{};
        ball.find_chords(move.columns, move.rows, chords);
        const EightWholeChords above = ball.chords_above(beside);
        for (std::size_t ray = 0; ray < 64; ++ray) {
            const std::size_t at = ball.height() == 0 ? ray / 8 : ray % 8;
            const EightWholeChords& of = chords[ray / 8];
            const bool is_empty = above.may.from[at] >= above.may.to[at];
            ASSERT_EQ(of.may.from[ray % 8] >= of.may.to[ray % 8], is_empty);
            if (is_empty)
                continue;
            EXPECT_EQ(of.may.from[ray % 8], above.may.from[at]);
            EXPECT_EQ(of.sure.to[ray % 8], above.sure.to[at]);
            ++compared;
        }
    });
    EXPECT_GT(compared, 5000);
}

// A ball of radius 3 moves by 4 along x. Rays along x, 1 above and 1 below the centre.
TEST(FixedAxisBall, LevelMoveHasTheChordsOfBothEnds)
{
    const DexelStock stock{block, 1};
    const auto ball = fixed_axis_ball(piece_of({-2, 0, -3}, {2, 0, -3}, Vec3::UnitZ()));
    const FixedAxisBallOnField on{*ball, 0, stock};
    const Eight columns{0, 1, 2, 2.5, 4, 5, 6, 7};    // y
    const Eight rows{1, -1, -2, -4, -5, -6, -7, -8};  // z
    std::array<EightWholeChords, 2> chords{};
    on.find_chords(columns, rows, chords);
    for (std::size_t row = 0; row < 2; ++row)
        for (std::size_t i = 0; i < 4; ++i) {
            const double below = row == 0 ? 0 : 1;
            const double half = std::sqrt(9 - columns[i] * columns[i] - below);
            EXPECT_NEAR(chords[row].may.from[i] * stock.unit(), 8 - half, 2e-6);
            EXPECT_NEAR(chords[row].sure.to[i] * stock.unit(), 12 + half, 2e-6);
        }
    for (std::size_t i = 4; i < 8; ++i)
        EXPECT_GE(chords[0].may.from[i], chords[0].may.to[i]);
}

TEST(FixedAxisBall, OtherMovesAreNone)
{
    const Vec3 from{0, 0, 0};
    const Vec3 to{1, 0, 0};
    const Vec3 up = Vec3::UnitZ();
    EXPECT_TRUE(fixed_axis_ball(piece_of(from, to, up)));
    EXPECT_FALSE(fixed_axis_ball(piece_of(from, to, Vec3{1e-6, 0, 1}.normalized())));
    const Vec3 leaning = Vec3{0.01, 0, 1}.normalized();
    EXPECT_FALSE(
        fixed_axis_ball({ToolMotion{{from, up}, {to, leaning}}, ball_body, 0, 0}));
    const ToolMotion motion{{from, up}, {to, up}};
    EXPECT_FALSE(fixed_axis_ball({motion, CuttingBody{Cutter::flat(radius)}, 0, 0}));
    EXPECT_FALSE(fixed_axis_ball({motion, CuttingBody{Cutter::ball(radius), 20}, 0, 0}));
}

}  // namespace
}  // namespace endmill
