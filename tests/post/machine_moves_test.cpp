// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/machine_moves.h"

#include <cmath>

#include <gtest/gtest.h>

#include "five_axis.h"

namespace endmill {
namespace {

using test::direction;
using test::part_on;
using test::rad;

// A turn of C with the tool at rest in the part: X and Y follow on a circle, and the tip stays
// within the tolerance.
TEST(MachineMoves, FollowATurnWithTheToolAtRest)
{
    const PartOnMachine setup = part_on("caB");
    const MachinePathOptions options{.tolerance = 0.01};
    const CutterLocation pose{{40, 0, 0}, {0, 0, 1}};
    MachineMoves moves{setup, options};
    moves.begin(pose, {0, 0}, {});
    moves.add({.from = pose,
               .to = pose,
               .from_rotary = {0, 0},
               .to_rotary = {rad(90), 0},
               .course = RotaryCourse::Even,
               .feed_mm_per_min = 300});
    const MachinePath made = moves.take();
    // Chords of a circle of radius 40 within 0.01: at most 2 acos(1 - 0.01/40) each.
    const double widest = 2 * std::acos(1 - 0.01 / 40);
    EXPECT_GE(made.report.pieces, rad(90) / widest);
    EXPECT_LE(made.report.pieces, 2 * rad(90) / widest);
    for (const AxisPositions& at : made.path.machine->positions)
        EXPECT_NEAR(at.xyz.head<2>().norm(), 40, 1e-12);
    // The machine's way, not that of the resting tip, sets the time.
    EXPECT_NEAR(made.report.time_min, 40 * rad(90) / 300, 0.001);
}

// A feed is that of the tip; a turn about the tip moves the rim of the cutter at the feed.
TEST(MachineMoves, TakeTheTimeOfTipOrRim)
{
    const PartOnMachine setup = part_on("Bca");
    const MachinePathOptions options{.cutter = Cutter::flat(6)};
    const CutterLocation from{{0, 0, 0}, direction(setup, 30, 0)};
    const CutterLocation to{{0, 0, 0}, direction(setup, 50, 0)};
    MachineMoves moves{setup, options};
    moves.begin(from, {0, rad(30)}, {});
    moves.add({.from = from,
               .to = to,
               .from_rotary = {0, rad(30)},
               .to_rotary = {0, rad(50)},
               .course = RotaryCourse::GreatArc,
               .feed_mm_per_min = 100});
    const MachinePath made = moves.take();
    EXPECT_NEAR(made.report.time_min, 6 * rad(20) / 100, 1e-12);
    EXPECT_NEAR(made.path.points.back().conditions.feed_mm_per_min.value_or(0), 100,
                1e-9);
}

TEST(MachineMoves, LeaveOutAMoveWithoutEffectInsideAPath)
{
    const PartOnMachine setup = part_on("caB");
    const MachinePathOptions options;
    const CutterLocation pose{{1, 2, 3}, {0, 0, 1}};
    MachineMoves moves{setup, options};
    moves.begin(pose, {0, 0}, {});
    moves.add({.from = pose,
               .to = pose,
               .from_rotary = {0, 0},
               .to_rotary = {0, 0},
               .course = RotaryCourse::GreatArc});
    const MachinePath made = moves.take();
    EXPECT_EQ(made.report.pieces, 0U);
    EXPECT_EQ(made.path.points.size(), 2U);  // the end of the move is a point of the path
    EXPECT_TRUE(std::isinf(made.minutes[1]));
}

}  // namespace
}  // namespace endmill
