// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/ramp_entry.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

ToolPath path_of(const std::vector<std::pair<Move, Vec3>>& moves)
{
    ToolPath path;
    for (const auto& [move, tip] : moves)
        path.points.push_back(
            {0, static_cast<int>(path.points.size()), move, 0, {tip, Vec3::UnitZ()}});
    return path;
}

std::vector<Vec3> tips_of(const ToolPath& path)
{
    std::vector<Vec3> tips;
    for (const PathPoint& point : path.points)
        tips.push_back(point.location.tip);
    return tips;
}

// A slope of 1 in 10 from 2 mm up needs 20 mm: 10 mm forward and 10 mm back.
TEST(RampEntry, GoesForwardAndBackAlongTheFirstCut)
{
    const ToolPath path = path_of({{Move::Plunge, {0, 0, 1}}, {Move::Cut, {30, 0, 1}}});
    const RampedPath ramped = with_ramps(path, 3, 0.1);
    EXPECT_EQ(tips_of(ramped.path),
              (std::vector<Vec3>{{10, 0, 2}, {0, 0, 1}, {30, 0, 1}}));
    EXPECT_EQ(ramped.path.points[0].move, Move::Plunge);
    EXPECT_EQ(ramped.path.points[1].move, Move::Plunge);
    EXPECT_EQ(ramped.path.points[2].move, Move::Cut);
    EXPECT_EQ(ramped.ramps, 1U);
    EXPECT_EQ(ramped.straight, 0U);
}

// Only 4 mm of cut: 20 mm need three ways forward and back of 10/3 mm each.
TEST(RampEntry, TurnsBackOftenOnAShortCut)
{
    const ToolPath path = path_of(
        {{Move::Plunge, {0, 0, 1}}, {Move::Cut, {0, 4, 1}}, {Move::Retract, {0, 4, 9}}});
    const std::vector<Vec3> tips = tips_of(with_ramps(path, 3, 0.1).path);
    ASSERT_EQ(tips.size(), 6U + 2U);
    for (int leg = 0; leg < 6; ++leg) {
        EXPECT_NEAR(tips[static_cast<std::size_t>(leg)].y(), leg % 2 == 0 ? 10.0 / 3 : 0,
                    1e-12);
        EXPECT_NEAR(tips[static_cast<std::size_t>(leg)].z(), 3 - (leg + 1) / 3.0, 1e-12);
    }
}

// Height of the path over a place on its way, by a search through all its segments.
double height_at(const ToolPath& path, const Vec3& place)
{
    double height = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k < path.points.size(); ++k) {
        const Vec3& from = path.points[k - 1].location.tip;
        const Vec3 along = path.points[k].location.tip - from;
        const double length = along.head<2>().squaredNorm();
        const double part =
            length > 0 ? (place - from).head<2>().dot(along.head<2>()) / length : 0;
        const Vec3 nearest = from + std::clamp(part, 0.0, 1.0) * along;
        if ((nearest - place).head<2>().norm() < 1e-9)
            height = std::max(height, nearest.z());
    }
    return height;
}

TEST(RampEntry, StaysAboveThePathAndFallsEvenly)
{
    ToolPath path = path_of({{Move::Plunge, {0, 0, -1}}});
    for (int k = 1; k <= 400; ++k)
        path.points.push_back(
            {0,
             k,
             Move::Cut,
             0,
             {{0.1 * k, std::sin(0.05 * k), -1 + std::cos(0.1 * k)}, Vec3::UnitZ()}});
    const double tangent = std::tan(0.05);
    const RampedPath ramped = with_ramps(path, 4, tangent);
    const std::size_t added = ramped.path.points.size() - path.points.size();
    ASSERT_GT(added, 100U);
    double over = 5;
    for (std::size_t k = 0; k < added; ++k) {
        const Vec3& tip = ramped.path.points[k].location.tip;
        const Vec3 before =
            k == 0 ? Vec3{0, 0, 4} : ramped.path.points[k - 1].location.tip;
        const double now = tip.z() - height_at(path, tip);
        EXPECT_GE(now, 0);
        EXPECT_NEAR(over - now, tangent * (tip - before).head<2>().norm(), 1e-9);
        over = now;
    }
    // The moves after the slope are those of the path.
    for (std::size_t k = 1; k < path.points.size(); ++k)
        EXPECT_EQ(ramped.path.points[added + k].location.tip,
                  path.points[k].location.tip);
}

// The way down is the same however many points it has.
TEST(RampEntry, JoinsVerticalPlunges)
{
    const ToolPath whole = path_of(
        {{Move::Rapid, {0, 0, 5}}, {Move::Plunge, {0, 0, 1}}, {Move::Cut, {90, 0, 1}}});
    const ToolPath pieces = path_of({{Move::Rapid, {0, 0, 5}},
                                     {Move::Plunge, {0, 0, 4}},
                                     {Move::Plunge, {0, 0, 4}},
                                     {Move::Plunge, {0, 0, 2}},
                                     {Move::Plunge, {0, 0, 1}},
                                     {Move::Cut, {90, 0, 1}}});
    const RampedPath ramped = with_ramps(pieces, 5, 0.1);
    EXPECT_EQ(tips_of(ramped.path), tips_of(with_ramps(whole, 5, 0.1).path));
    EXPECT_EQ(ramped.ramps, 1U);
    EXPECT_EQ(ramped.straight, 0U);
    // Without a cut all points remain, and the descent counts once.
    ToolPath cutless = pieces;
    cutless.points.pop_back();
    const RampedPath straight = with_ramps(cutless, 5, 0.1);
    EXPECT_EQ(tips_of(straight.path), tips_of(cutless));
    EXPECT_EQ(straight.straight, 1U);
}

TEST(RampEntry, LeavesOtherMovesAsTheyAre)
{
    const ToolPath path = path_of({{Move::Rapid, {0, 0, 5}},
                                   {Move::Cut, {0, 0, 1}},
                                   {Move::Retract, {0, 0, 5}},
                                   {Move::Plunge, {0, 0, 0}},
                                   {Move::Link, {9, 0, 0}},
                                   {Move::Retract, {9, 0, 5}},
                                   {Move::Plunge, {9, 0, 0}},
                                   {Move::Cut, {9, 0.01, 0}},
                                   {Move::Retract, {9, 0.01, 5}},
                                   {Move::Plunge, {9, 0.01, 0}},
                                   {Move::Cut, {9, 0.01, -1}}});
    const RampedPath ramped = with_ramps(path, 5, 0.1);
    EXPECT_EQ(tips_of(ramped.path), tips_of(path));
    EXPECT_EQ(ramped.ramps, 0U);
    EXPECT_EQ(ramped.straight, 3U);
}

TEST(RampEntry, DoesNotRunIntoTheCutsOfAnotherTool)
{
    ToolPath path = path_of(
        {{Move::Plunge, {0, 0, 0}}, {Move::Cut, {5, 0, 0}}, {Move::Cut, {50, 0, 0}}});
    path.points[0].conditions.tool = 1;
    path.points[1].conditions.tool = 1;
    path.points[2].conditions.tool = 2;
    for (const Vec3& tip : tips_of(with_ramps(path, 10, 0.5).path))
        EXPECT_LE(tip.x() < 50 ? tip.x() : 0, 5);
}

TEST(RampEntry, RefusesAnglesOutsideItsDomain)
{
    const ToolPath path = path_of({{Move::Plunge, {0, 0, 0}}});
    for (const double tangent : {0.0, -1.0, std::nan(""), HUGE_VAL})
        EXPECT_THROW(with_ramps(path, 1, tangent), DomainError);
}

}  // namespace
}  // namespace endmill
