// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/descent.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

PathPoint point(Move move, const Vec3& tip, int tool = 1)
{
    return {0, 0, move, 0, {tip, Vec3::UnitZ()}, {}, {{}, {}, tool}};
}

TEST(Descent, JoinsPlungesOneBelowTheOther)
{
    const ToolPath path{{point(Move::Rapid, {1, 2, 9}), point(Move::Plunge, {1, 2, 4}),
                         point(Move::Plunge, {1, 2, 4}), point(Move::Plunge, {1, 2, -1}),
                         point(Move::Cut, {5, 2, -1})}};
    const auto descent = descent_at(path, 1, 20);
    ASSERT_TRUE(descent);
    EXPECT_EQ(descent->first, 1U);
    EXPECT_EQ(descent->last, 3U);
    EXPECT_EQ(descent->from, 9);
    EXPECT_EQ(descent->to, -1);
    EXPECT_TRUE(leads_to_cut(path, *descent));
    for (const std::size_t other : {0U, 4U})
        EXPECT_FALSE(descent_at(path, other, 20)) << other;
}

TEST(Descent, ToTheFirstPointBeginsAtTheStartHeight)
{
    for (const Move move : {Move::Plunge, Move::Cut}) {
        const ToolPath path{{point(move, {1, 2, 3}), point(Move::Cut, {2, 2, 3})}};
        EXPECT_EQ(descent_at(path, 0, 20).value().from, 20);
        EXPECT_FALSE(descent_at(path, 0, 3)) << "nothing is left of it";
    }
    EXPECT_FALSE(descent_at({{point(Move::Rapid, {1, 2, 3})}}, 0, 20));
}

TEST(Descent, EndsAtAnotherToolAndAtAMoveThatIsNotVertical)
{
    const ToolPath path{{point(Move::Rapid, {0, 0, 9}), point(Move::Plunge, {0, 0, 4}),
                         point(Move::Plunge, {0, 0, 2}, 2),
                         point(Move::Plunge, {1, 0, 1}, 2)}};
    const auto before = descent_at(path, 1, 9);
    ASSERT_TRUE(before);
    EXPECT_EQ(before->last, 1U);
    EXPECT_FALSE(leads_to_cut(path, *before)) << "another tool";
    EXPECT_EQ(descent_at(path, 2, 9).value().last, 2U);
    EXPECT_FALSE(descent_at(path, 3, 9)) << "slanted";
}

TEST(Descent, WithoutACutDrills)
{
    for (const Move next : {Move::Retract, Move::Rapid, Move::Link}) {
        const ToolPath path{{point(Move::Plunge, {0, 0, 0}), point(next, {0, 3, 9})}};
        EXPECT_FALSE(leads_to_cut(path, *descent_at(path, 0, 9)));
    }
    const ToolPath end{{point(Move::Plunge, {0, 0, 0})}};
    EXPECT_FALSE(leads_to_cut(end, *descent_at(end, 0, 9)));
}

}  // namespace
}  // namespace endmill
