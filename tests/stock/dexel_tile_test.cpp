// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/dexel_tile.h"

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

const Block block{{0, 0, 0}, {7, 6.4, 9}};
constexpr double pitch = 0.5;
// Both routes round outwards; the search on single rays ends within its own accuracy.
constexpr std::int64_t most_units = 16;

// The search counts every interval of a ray by itself, so that its depth may be less.
void expect_near(const DexelCut& cut, const DexelCut& expected)
{
    EXPECT_GE(cut.deepest, expected.deepest - most_units);
    EXPECT_GE(cut.most_deep, expected.most_deep - most_units);
    EXPECT_LE(cut.deepest, cut.most_deep);
    EXPECT_NEAR(static_cast<double>(cut.removed), static_cast<double>(expected.removed),
                64 * 2 * most_units);
}

ToolPiece random_piece(test::Random& random, Vec3& tip, const Vec3& axis,
                       const CuttingBody& body)
{
    const Vec3 way{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const Vec3 from = tip;
    tip = (tip + way).cwiseMax(block.low).cwiseMin(block.high);
    return {ToolMotion{{from, axis}, {tip, axis}}, body, 0, 0};
}

// A tile cut by closed forms and gaps, and one cut by searches on rays. Between them pieces
// of a leaning axis cut both by searches, and a body is tested.
TEST(DexelTile, FixedAxisBallCutsAsTheSearchDoes)
{
    test::Random random{9};
    const CuttingBody body{Cutter::ball(1.5)};
    const CuttingBody shank = CuttingBody::of_cylinder({2, 2, 20});
    const DexelStock stock{block, pitch};
    std::int64_t removed = 0;
    for (int number = 0; number < 18; ++number) {
        const Vec3 axis = (number % 2 == 0 ? 1 : -1) * Vec3::Unit(number / 2 % 3);
        const int field = number / 6;
        DexelTile by_forms{stock, field, 8, 8};
        DexelTile by_search{stock, field, 8, 8};
        Vec3 tip{5.5, 5, 6};
        for (int k = 0; k < 60; ++k) {
            const bool leans = k % 11 == 10;
            const Vec3 along = leans ? Vec3{1, 2, 2}.normalized() : axis;
            const ToolPiece piece = random_piece(random, tip, along, body);
            const DexelCut expected = by_search.cut(piece);
            removed += expected.removed;
            const auto ball = fixed_axis_ball(piece);
            ASSERT_EQ(ball.has_value(), !leans);
            if (ball) {
                const FixedAxisBallOnField on{*ball, field, stock};
                if (by_forms.is_reached(on))
                    expect_near(by_forms.cut(piece, on), expected);
                else
                    expect_near({}, expected);
            } else {
                expect_near(by_forms.cut(piece), expected);
            }
            const ToolPiece beside{piece.motion, shank, 0, 0};
            EXPECT_NEAR(static_cast<double>(by_forms.depth_in(beside).depth),
                        static_cast<double>(by_search.depth_in(beside).depth),
                        most_units);
        }
    }
    // Of both sets, about a tenth of the material of the tiles.
    EXPECT_GT(static_cast<double>(removed) * stock.unit(), 0.1 * 2 * 18 * 40 * 6);
}

}  // namespace
}  // namespace endmill
