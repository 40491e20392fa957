// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/dexel_removal.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/angle.h"
#include "endmill/core/parallel.h"

namespace endmill {
namespace {

using std::numbers::pi;

double rad(double degrees)
{
    return Angle::degrees(degrees).radians();
}

// Removes the motions between neighbouring locations from a block.
DexelRemoval removed(const Block& block, const std::vector<CutterLocation>& path,
                     const CuttingBody& body, double pitch,
                     std::optional<CuttingBody> shank = {})
{
    DexelStock stock{block, pitch};
    std::vector<ToolPiece> pieces;
    std::vector<ToolPiece> bodies;
    for (std::size_t k = path.size() > 1 ? 1 : 0; k < path.size(); ++k) {
        const auto point = static_cast<std::int32_t>(k);
        const ToolMotion motion{path[k == 0 ? 0 : k - 1], path[k]};
        pieces.push_back({motion, body, point, point});
        if (shank)
            bodies.push_back({motion, *shank, point, point});
    }
    const Sphere region{(block.low + block.high) / 2,
                        (block.high - block.low).norm() / 2 + 1};
    const ToolPieces cutters{pieces, region};
    const ToolPieces shanks{bodies, region};
    return remove_from_dexels(stock, {cutters, shanks, path.size()});
}

// Poses on an arc of the axis about a centre that stays, as a fine path.
std::vector<CutterLocation> turned_about(const Vec3& centre, double height, double from,
                                         double to, int steps)
{
    std::vector<CutterLocation> path;
    for (int k = 0; k <= steps; ++k) {
        const double angle = from + k * (to - from) / steps;
        const Vec3 axis{std::sin(angle), 0, std::cos(angle)};
        path.push_back({centre - height * axis, axis});
    }
    return path;
}

void expect_volume(const DexelRemoval& found, double exact, double share = 0)
{
    EXPECT_NEAR(found.removed, exact, found.bound + found.spread + share * exact);
    double sum = 0;
    for (const DexelMove& move : found.moves)
        sum += move.removed;
    EXPECT_NEAR(sum, found.removed, 1e-9 * exact);
}

const Block half_space{{-15, -15, -15}, {15, 15, 0}};

TEST(DexelRemoval, OnePoseInAHalfSpace)
{
    const Vec3 axis{std::sin(rad(30)), 0, std::cos(rad(30))};
    // Ball centre, or middle of the disc, 6 deep along the axis.
    const double along = 6;
    const DexelRemoval ball = removed(half_space, {{-along * axis - 5 * axis, axis}},
                                      CuttingBody{Cutter::ball(5)}, 0.25);
    expect_volume(ball, pi * 25 * 6 + 2 * pi / 3 * 125, 1e-3);
    EXPECT_NEAR(pi * 25 * 6 + 2 * pi / 3 * 125, 733.0382858, 1e-6);
    const DexelRemoval flat =
        removed(half_space, {{-along * axis, axis}}, CuttingBody{Cutter::flat(5)}, 0.25);
    expect_volume(flat, 471.2388980, 1e-3);
}

TEST(DexelRemoval, BallTurnedAboutItsCentreRemovesNothingMore)
{
    const Vec3 centre{0, 0, 2.5};  // 2.5 deep
    const double cap = pi * 2.5 * 2.5 * (15 - 2.5) / 3;
    const DexelRemoval turned =
        removed(half_space, turned_about(centre, 5, rad(-30), rad(30), 30),
                CuttingBody{Cutter::ball(5)}, 0.1);
    expect_volume(turned, cap, 1e-3);
    EXPECT_LT(turned.bound, 1e-3 * cap);
    // Coarse motions have a wider bound that contains the truth.
    const DexelRemoval coarse =
        removed(half_space, turned_about(centre, 5, rad(-30), rad(30), 2),
                CuttingBody{Cutter::ball(5)}, 0.1);
    expect_volume(coarse, cap, 1e-3);
}

TEST(DexelRemoval, FlatTurnedAboutItsTip)
{
    const double exact = 2.0 / 3 * 125 * std::tan(rad(30));
    EXPECT_NEAR(exact, 48.1125224, 1e-6);
    const DexelRemoval found =
        removed(half_space, turned_about({0, 0, 0}, 0, 0, rad(30), 12),
                CuttingBody{Cutter::flat(5)}, 0.1);
    expect_volume(found, exact, 2e-3);
}

// A whole turn about z at a radius cuts a torus-like groove of the ball's section.
TEST(DexelRemoval, RingOfABallIsItsSectionTimesTheCircle)
{
    std::vector<CutterLocation> path;
    for (int k = 0; k <= 720; ++k) {
        const double a = k * 2 * pi / 720;
        // A lead of 0.3 along the ring, the ball's centre 4 above the top.
        const Vec3 feed{-std::sin(a), std::cos(a), 0};
        const Vec3 axis = std::cos(0.3) * Vec3::UnitZ() + std::sin(0.3) * feed;
        const Vec3 centre{20 * std::cos(a), 20 * std::sin(a), 4};
        path.push_back({centre - 5 * axis, axis});
    }
    const DexelRemoval found =
        removed({{-27, -27, -2}, {27, 27, 0}}, path, CuttingBody{Cutter::ball(5)}, 0.3);
    expect_volume(found, 513.6538822, 1e-3);
}

TEST(DexelRemoval, PiecesOfAMotionRemoveTheSameAsTheWhole)
{
    const CutterLocation from{{-3, 0, -1}, {0, 0, 1}};
    const CutterLocation to{{3, 1, -2}, Vec3{0.2, 0.1, 1}.normalized()};
    const ToolMotion motion{from, to};
    const auto divided = [&](int count) {
        std::vector<CutterLocation> path;
        for (int k = 0; k <= count; ++k)
            path.push_back(motion.location(k / static_cast<double>(count)));
        return path;
    };
    for (const Cutter& cutter : {Cutter::ball(3), Cutter::flat(3), Cutter{3, 1}}) {
        const CuttingBody body{cutter};
        const DexelRemoval whole = removed(half_space, {from, to}, body, 0.5);
        // A straight tip with an even turn: the parts follow the same motion only if the
        // arc is divided evenly, as here.
        for (const int count : {2, 10}) {
            const DexelRemoval parts = removed(half_space, divided(count), body, 0.5);
            EXPECT_NEAR(parts.removed, whole.removed, parts.bound + whole.bound + 1e-9);
        }
        const DexelRemoval back = removed(half_space, {to, from}, body, 0.5);
        EXPECT_NEAR(back.removed, whole.removed, back.bound + whole.bound + 1e-9);
    }
}

TEST(DexelRemoval, WithoutATurnTheBoundIsRounding)
{
    const DexelRemoval found =
        removed(half_space, {{{-5, 0, -1}, {0, 0, 1}}, {{5, 0, -1}, {0, 0, 1}}},
                CuttingBody{Cutter::ball(5)}, 0.2);
    const double section = 25 * std::acos(1 - 0.2) - 4 * std::sqrt(9);
    expect_volume(found, 10 * section + pi * (15 - 1) / 3, 2e-3);
    EXPECT_LT(found.bound, 1e-4 * found.removed);
}

TEST(DexelRemoval, FiniteCutterLeavesMaterialAbove)
{
    // A disc of 4 mm height moves through the middle of a tall block.
    const Block tall{{-10, -10, -10}, {10, 10, 10}};
    const DexelRemoval found =
        removed(tall, {{{-20, 0, -2}, {0, 0, 1}}, {{20, 0, -2}, {0, 0, 1}}},
                CuttingBody{Cutter::flat(3), 4}, 0.25);
    expect_volume(found, 20 * 6 * 4, 1e-6);
}

TEST(DexelRemoval, ShankIsFoundInMaterialBeforeItsOwnMoveCuts)
{
    const CuttingBody shank = CuttingBody::of_cylinder({12, 3, 30});
    // The cutter goes 5 deep, so the wider shank enters by 2.
    const DexelRemoval found =
        removed(half_space, {{{0, 0, 4}, {0, 0, 1}}, {{0, 0, -5}, {0, 0, 1}}},
                CuttingBody{Cutter::flat(3)}, 0.25, shank);
    EXPECT_NEAR(found.moves[1].body_depth, 12, 0.3);  // across, on rays along x and y
    const DexelRemoval clear =
        removed(half_space, {{{0, 0, 4}, {0, 0, 1}}, {{0, 0, -2}, {0, 0, 1}}},
                CuttingBody{Cutter::flat(3)}, 0.25, shank);
    EXPECT_EQ(clear.moves[1].body_depth, 0);
    EXPECT_EQ(clear.moves[1].most_body_depth, 0);
}

TEST(DexelRemoval, IsTheSameWithAnyNumberOfThreads)
{
    const auto path = turned_about({0, 0, 2.5}, 5, rad(-30), rad(30), 7);
    const auto found = [&] {
        return removed(half_space, path, CuttingBody{Cutter{5, 1}}, 0.4);
    };
    set_thread_count(1);
    const DexelRemoval one = found();
    for (const int threads : {2, 3, 8}) {
        set_thread_count(threads);
        const DexelRemoval other = found();
        EXPECT_EQ(one.removed, other.removed);
        EXPECT_EQ(one.bound, other.bound);
        for (std::size_t k = 0; k < one.moves.size(); ++k)
            EXPECT_EQ(one.moves[k].removed, other.moves[k].removed);
    }
    set_thread_count(2);
}

}  // namespace
}  // namespace endmill
