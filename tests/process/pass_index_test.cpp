// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/pass_index.h"

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "pass_examples.h"

namespace endmill {
namespace {

// The rules of the header, applied to every earlier move.
NeighbouringPasses looked_through(const std::vector<CutMove>& moves, std::size_t number,
                                  double reach)
{
    const CutMove& own = moves[number];
    const Vec3 way = own.direction();
    NeighbouringPasses found;
    for (std::size_t i = 0; i < number; ++i) {
        const CutMove& other = moves[i];
        const double slant = other.direction().dot(way);
        if (std::abs(slant) < std::sqrt(0.5))
            continue;
        const double along =
            (own.middle() - other.from()).dot(way) / slant;  // mm from its start
        if (along < 0 || along > other.length_mm)
            continue;
        if (other.pass() == own.pass() &&
            own.middle_mm() - other.begin_mm - along < reach)
            continue;
        const Vec3 offset = own.middle() - (other.from() + along * other.direction());
        auto& side = offset.cross(way).z() < 0 ? found.right : found.left;
        if (offset.norm() < (side ? side->distance : reach))
            side = PassCrossing{i, along / other.length_mm, offset, offset.norm()};
    }
    return found;
}

// A wavy surface with zigzag passes at an angle and moves of random lengths.
ToolPath wavy_path(double slant)
{
    std::mt19937 random{7};
    std::uniform_real_distribution<double> length{0.2, 2};
    ToolPath path;
    for (int pass = 0; pass < 14; ++pass)
        for (double x = 0; x < 40; x += length(random)) {
            const double along = pass % 2 == 0 ? x : 40 - x;
            const double across = 1.3 * pass;
            const Vec3 tip{std::cos(slant) * along - std::sin(slant) * across,
                           std::sin(slant) * along + std::cos(slant) * across,
                           4 * std::sin(along / 7) * std::cos(across / 5)};
            path.points.push_back(
                {pass, 0, x == 0 ? Move::Rapid : Move::Cut, 0, {tip, Vec3::UnitZ()}});
        }
    return path;
}

void expect_same(const std::optional<PassCrossing>& one,
                 const std::optional<PassCrossing>& other)
{
    ASSERT_EQ(one.has_value(), other.has_value());
    if (one) {
        EXPECT_NEAR(one->distance, other->distance, 1e-12);
        EXPECT_LT((one->offset - other->offset).norm(), 1e-11);
    }
}

void expect_same_as_exhaustive_search(const ToolPath& path)
{
    const std::vector<CutMove> moves = cut_moves(path);
    const PassIndex index{moves};
    for (const double reach : {1.0, 3.0, 12.0}) {
        NeighbouringPasses last;
        for (std::size_t i = 0; i < moves.size(); ++i) {
            const NeighbouringPasses fast = index.beside(i, reach);
            const NeighbouringPasses slow = looked_through(moves, i, reach);
            expect_same(fast.left, slow.left);
            expect_same(fast.right, slow.right);
            last = index.beside(i, reach, last);
            expect_same(last.left, fast.left);
            expect_same(last.right, fast.right);
        }
    }
}

TEST(PassIndex, FindsTheSameAsExhaustiveSearch)
{
    for (const double slant : {0.0, 0.3, 1.1, std::numbers::pi / 2})
        expect_same_as_exhaustive_search(wavy_path(slant));
}

// The moves of a spiral run in all directions, so no strips fit them. Its turns are passes.
TEST(PassIndex, FindsTheSameAsExhaustiveSearchOnASpiral)
{
    ToolPath path;
    for (double angle = 0.1; angle < 60; angle += 0.7 / (1 + 0.2 * angle))
        path.points.push_back(
            {static_cast<int>(angle / (2 * std::numbers::pi)),
             0,
             Move::Cut,
             0,
             {{0.3 * angle * std::cos(angle), 0.3 * angle * std::sin(angle), 0.1 * angle},
              Vec3::UnitZ()}});
    expect_same_as_exhaustive_search(path);
}

// The same path cut three times: the crossings of its first two runs are equally near.
TEST(PassIndex, KeepsTheCrossingThatIsCutLastOfEquallyNearOnes)
{
    const ToolPath once = wavy_path(0.3);
    ToolPath path;
    for (int run = 0; run < 3; ++run)
        for (PathPoint point : once.points) {
            point.pass += 100 * run;
            point.location.tip.z() -= run == 2 ? 0.25 : 0;
            path.points.push_back(point);
        }
    const std::vector<CutMove> moves = cut_moves(path);
    const std::size_t count = moves.size() / 3;
    const PassIndex index{moves};
    for (std::size_t i = 2 * count; i < moves.size(); ++i) {
        const NeighbouringPasses found = index.beside(i, 3);
        for (const auto& crossing : {found.left, found.right})
            EXPECT_TRUE(!crossing || crossing->move >= count) << i;
    }
}

TEST(PassIndex, LeavesOutTheOwnPassNearbyButNotFurtherOn)
{
    // A single pass that returns beside itself.
    ToolPath path;
    for (const Vec3& tip : {Vec3{0, 0, 0}, Vec3{10, 0, 0}, Vec3{20, 0, 0}, Vec3{20, 1, 0},
                            Vec3{10, 1, 0}, Vec3{0, 1, 0}})
        path.points.push_back({0, 0, Move::Cut, 0, {tip, Vec3::UnitZ()}});
    const std::vector<CutMove> moves = cut_moves(path);
    const PassIndex index{moves};
    EXPECT_FALSE(index.beside(3, 15).left);  // its neighbour is 11 mm of path away
    EXPECT_TRUE(index.beside(3, 10).left);
    EXPECT_TRUE(index.beside(4, 15).left);  // 31 mm away
}

TEST(PassIndex, IgnoresAPassAboveAndFindsAPassInPlace)
{
    const ToolPath path = passes({{Vec3{0, 0, 0}, Vec3{20, 0, 0}},
                                  {Vec3{0, 0, -2}, Vec3{20, 0, -2}},
                                  {Vec3{0, 0, -2}, Vec3{20, 0, -2}}},
                                 1);
    const std::vector<CutMove> moves = cut_moves(path);
    const PassIndex index{moves};
    const NeighbouringPasses above = index.beside(1, 10);
    EXPECT_FALSE(above.left || above.right);
    EXPECT_EQ(index.beside(2, 10).left.value().distance, 0);
}

TEST(PassIndex, LeavesOutCrossingMoves)
{
    for (const double degrees : {40.0, 50.0, 130.0, 140.0}) {
        const double angle = degrees * std::numbers::pi / 180;
        const Vec3 way{std::cos(angle), std::sin(angle), 0};
        const Vec3 beside{0, 2, 0};
        const ToolPath path = passes(
            {{beside - 10 * way, beside + 10 * way}, {Vec3{-5, 0, 0}, Vec3{5, 0, 0}}}, 1);
        const std::vector<CutMove> moves = cut_moves(path);
        EXPECT_EQ(PassIndex{moves}.beside(1, 10).left.has_value(),
                  std::abs(degrees - 90) > 45);
    }
}

}  // namespace
}  // namespace endmill
