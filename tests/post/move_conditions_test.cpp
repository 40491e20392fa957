// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/move_conditions.h"

#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "path_conditions.h"

namespace endmill {
namespace {

// A plunge, a rapid and a cut.
ToolPath three_moves(const std::vector<CuttingConditions>& conditions)
{
    const CutterLocation location{Vec3::Zero(), Vec3::UnitZ()};
    return test::with_conditions({{{0, 0, Move::Plunge, 0, location},
                                   {0, 1, Move::Rapid, 0, location},
                                   {0, 2, Move::Cut, 0, location}}},
                                 conditions);
}

std::string refusal(const ToolPath& path, const CuttingConditions& otherwise,
                    int decimals = 4)
{
    try {
        MoveConditions conditions{path, otherwise, {decimals, decimals}};
        for (std::size_t k = 0; k < path.points.size(); ++k)
            conditions.at(k);
        return "accepted";
    } catch (const DomainError& error) {
        return error.what();
    }
}

TEST(MoveConditions, OfThePathPrecedeTheGivenDefaults)
{
    const ToolPath path = three_moves({{100, 2000, 7}, {200, {}, {}}, {{}, {}, {}}});
    MoveConditions conditions{path, {300, 3000, 1}, {}};
    EXPECT_EQ(conditions.at(0), (CuttingConditions{100, 2000, 7}));
    EXPECT_EQ(conditions.at(1), (CuttingConditions{{}, 3000, 1}));
    EXPECT_EQ(conditions.at(2), (CuttingConditions{300, 3000, 1}));
    EXPECT_EQ(conditions.plunge_feeds().greatest, 100);
    EXPECT_EQ(conditions.feeds().least, 300);
    EXPECT_EQ(conditions.speeds().least, 2000);
}

TEST(MoveConditions, OfAPathWithoutAnyAreTheGivenDefaults)
{
    const ToolPath path = three_moves({});
    MoveConditions conditions{path, {300, {}, {}}, {}};
    EXPECT_EQ(conditions.at(0), (CuttingConditions{300, {}, {}}));
    EXPECT_EQ(conditions.at(1), CuttingConditions{});
}

TEST(MoveConditions, RefuseAMoveWithoutAFeedAndNameIt)
{
    EXPECT_THAT(refusal(three_moves({}), {}),
                testing::HasSubstr("point 0 of the path has no feed"));
    EXPECT_THAT(refusal(three_moves({{100, {}, {}}, {}, {}}), {}),
                testing::HasSubstr("point 2 of the path has no feed"));
    EXPECT_EQ(refusal(three_moves({{100, {}, {}}, {}, {200, {}, {}}}), {}), "accepted");
}

TEST(MoveConditions, RefuseAFeedThatRoundsToZero)
{
    EXPECT_THAT(refusal(three_moves({}), {0.4, {}, {}}, 0),
                testing::HasSubstr("0.4 mm/min, which rounds to 0 with 0 decimals"));
    EXPECT_THAT(refusal(three_moves({}), {4e-5, {}, {}}), testing::HasSubstr("rounds"));
    EXPECT_EQ(refusal(three_moves({}), {0.4, {}, {}}, 1), "accepted");
    EXPECT_EQ(refusal(three_moves({}), {6e-5, {}, {}}), "accepted");
}

// 0.001 mm/min is 3.9e-5 inch/min, which rounds to 0 with four decimals.
TEST(MoveConditions, RoundAFeedInTheUnitOfTheProgram)
{
    const ToolPath path = three_moves({{0.001, {}, {}}});
    MoveConditions in_mm{path, {}, {4, 4, 1}};
    EXPECT_NO_THROW(in_mm.at(0));
    MoveConditions in_inches{path, {}, {4, 4, 25.4}};
    EXPECT_THROW(in_inches.at(0), DomainError);
}

TEST(MoveConditions, RefuseNumbersOutOfTheirRange)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double feed : {0.0, -1.0, nan, infinity})
        EXPECT_THAT(refusal(three_moves({}), {feed, {}, {}}), testing::HasSubstr("feed"));
    for (const double speed : {0.0, 1e-5, -1.0, nan, infinity})
        EXPECT_THAT(refusal(three_moves({}), {1, speed, {}}),
                    testing::HasSubstr("speed"));
    EXPECT_THAT(refusal(three_moves({}), {1, {}, -1}), testing::HasSubstr("tool -1"));
}

}  // namespace
}  // namespace endmill
