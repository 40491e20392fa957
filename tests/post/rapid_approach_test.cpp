// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/rapid_approach.h"

#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

using Moves = std::vector<std::pair<Move, Vec3>>;

ToolPath path_of(const Moves& moves)
{
    ToolPath path;
    for (const auto& [move, tip] : moves)
        path.points.push_back(
            {0, static_cast<int>(path.points.size()), move, 0, {tip, Vec3::UnitZ()}});
    return path;
}

Moves moves_of(const ToolPath& path)
{
    Moves moves;
    for (const PathPoint& point : path.points)
        moves.emplace_back(point.move, point.location.tip);
    return moves;
}

TEST(RapidApproach, IsARapidDownToTheDistanceAboveTheEnd)
{
    const ToolPath path = path_of(
        {{Move::Rapid, {1, 2, 30}}, {Move::Plunge, {1, 2, -4}}, {Move::Cut, {9, 2, -4}}});
    EXPECT_EQ(moves_of(with_rapid_approach(path, 30, 1.5)),
              (Moves{{Move::Rapid, {1, 2, 30}},
                     {Move::Rapid, {1, 2, -2.5}},
                     {Move::Plunge, {1, 2, -4}},
                     {Move::Cut, {9, 2, -4}}}));
}

TEST(RapidApproach, AlsoLeadsToTheFirstPoint)
{
    for (const Move move : {Move::Plunge, Move::Cut}) {
        const ToolPath path = path_of({{move, {1, 2, 0}}, {Move::Cut, {9, 2, 0}}});
        EXPECT_EQ(moves_of(with_rapid_approach(path, 30, 2)),
                  (Moves{{Move::Rapid, {1, 2, 2}},
                         {Move::Plunge, {1, 2, 0}},
                         {Move::Cut, {9, 2, 0}}}));
    }
}

// The steps above the distance are passed at once, those below stay.
TEST(RapidApproach, OfADescentInStepsHasTheDistanceAboveTheLastOne)
{
    const ToolPath path = path_of({{Move::Plunge, {0, 0, 20}},
                                   {Move::Plunge, {0, 0, 3}},
                                   {Move::Plunge, {0, 0, 2}},
                                   {Move::Plunge, {0, 0, 1}},
                                   {Move::Plunge, {0, 0, 0}},
                                   {Move::Cut, {9, 0, 0}}});
    EXPECT_EQ(moves_of(with_rapid_approach(path, 30, 2)),
              (Moves{{Move::Rapid, {0, 0, 2}},
                     {Move::Plunge, {0, 0, 1}},
                     {Move::Plunge, {0, 0, 0}},
                     {Move::Cut, {9, 0, 0}}}));
}

TEST(RapidApproach, KeepsShortDescentsAndThoseThatDrill)
{
    const ToolPath path = path_of({{Move::Plunge, {0, 0, 8}},
                                   {Move::Cut, {5, 0, 8}},
                                   {Move::Rapid, {5, 0, 30}},
                                   {Move::Plunge, {5, 0, -20}},
                                   {Move::Retract, {5, 0, 30}},
                                   {Move::Plunge, {5, 0, 2}},
                                   {Move::Plunge, {6, 0, 1}},
                                   {Move::Cut, {9, 0, 1}}});
    EXPECT_EQ(moves_of(with_rapid_approach(path, 10, 2)), moves_of(path));
}

TEST(RapidApproach, KeepsTheConditionsOfTheDescent)
{
    ToolPath path = path_of({{Move::Plunge, {0, 0, 0}}, {Move::Cut, {9, 0, 0}}});
    for (PathPoint& point : path.points)
        point.conditions = {80, 900, 7};
    const ToolPath found = with_rapid_approach(path, 10, 2);
    EXPECT_EQ(found.points[0].conditions, path.points[0].conditions);
    EXPECT_EQ(found.points[1].conditions, path.points[0].conditions);
}

TEST(RapidApproach, RefusesDistancesOutsideItsDomain)
{
    const ToolPath path = path_of({{Move::Plunge, {0, 0, 0}}});
    for (const double distance : {0.0, -1.0, std::nan(""), HUGE_VAL})
        EXPECT_THROW(with_rapid_approach(path, 1, distance), DomainError);
}

}  // namespace
}  // namespace endmill
