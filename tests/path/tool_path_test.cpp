// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/path/tool_path.h"

#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace endmill {
namespace {

constexpr Move moves[] = {Move::Cut, Move::Link, Move::Rapid, Move::Plunge,
                          Move::Retract};

TEST(Move, HasTheWordsOfThePathFormat)
{
    EXPECT_EQ(move_name(Move::Cut), "cut");
    EXPECT_EQ(move_name(Move::Link), "link");
    EXPECT_EQ(move_name(Move::Rapid), "rapid");
    EXPECT_EQ(move_name(Move::Plunge), "plunge");
    EXPECT_EQ(move_name(Move::Retract), "retract");
}

TEST(Move, HasADifferentWordForEachKind)
{
    std::set<std::string_view> words;
    for (const Move move : moves)
        words.insert(move_name(move));
    EXPECT_EQ(words.size(), std::size(moves));
    EXPECT_FALSE(words.contains(""));
}

TEST(ToolPath, OfAnEmptyPassHasNoPoints)
{
    EXPECT_TRUE(ToolPath{}.points.empty());
}

TEST(ToolPath, CanLackAContact)
{
    ToolPath path;
    path.points.push_back({0, 0, Move::Rapid, 0, {{1, 2, 3}, Vec3::UnitZ()}});
    path.points.push_back({0,
                           1,
                           Move::Plunge,
                           0,
                           {{1, 2, 0}, Vec3::UnitZ()},
                           SurfaceContact{0.5, 0, {{1, 2, 0}, Vec3::UnitZ()}}});
    const ToolPath copy = path;
    EXPECT_FALSE(copy.points[0].contact());
    EXPECT_FALSE(copy.points[0].normal());
    EXPECT_EQ(copy.points[1].contact()->u, 0.5);
    EXPECT_EQ(*copy.points[1].normal(), Vec3(Vec3::UnitZ()));
}

// A path from a file may state the normals of the part and nothing else of the contacts.
TEST(ToolPath, CanHaveANormalWithoutTheRestOfTheContact)
{
    const PathPoint point{
        0, 0, Move::Cut, 0, {{1, 2, 3}, Vec3::UnitZ()}, Vec3{0, 0.6, 0.8}};
    EXPECT_FALSE(point.contact());
    EXPECT_EQ(*point.normal(), Vec3(0, 0.6, 0.8));
}

ToolPath path_along(const std::vector<std::pair<Move, double>>& heights)
{
    ToolPath path;
    for (const auto& [move, z] : heights)
        path.points.push_back({0,
                               static_cast<int>(path.points.size()),
                               move,
                               0,
                               {{0, 0, z}, Vec3::UnitZ()}});
    return path;
}

TEST(EntryHeight, IsTheStartOfTheFirstMoveAtFeedIfItLeadsDown)
{
    using enum Move;
    EXPECT_EQ(
        entry_height(path_along({{Rapid, 30}, {Rapid, 2}, {Plunge, -1}, {Cut, -1}})), 2);
    EXPECT_EQ(entry_height(path_along({{Cut, 5}, {Cut, 4}, {Plunge, 0}})), 5);
    EXPECT_EQ(entry_height(path_along({{Rapid, 5}, {Cut, 5}, {Plunge, 0}})),
              std::nullopt);
    EXPECT_EQ(entry_height(path_along({{Rapid, 5}, {Retract, 9}})), std::nullopt);
    EXPECT_EQ(entry_height({}), std::nullopt);
}

}  // namespace
}  // namespace endmill
