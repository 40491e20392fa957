// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/stock_history.h"

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "tip_path.h"

namespace endmill {
namespace {

void expect_same(const StraightSweep& found, const StraightSweep& expected)
{
    EXPECT_EQ(found.cutter(), expected.cutter());
    EXPECT_EQ(found.from(), expected.from());
    EXPECT_EQ(found.to(), expected.to());
}

TEST(PathSweeps, BeginWhereTheCutterStandsUnlessItComesFast)
{
    ToolPath path = test::tip_path({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
    EXPECT_EQ(path_sweeps(path, Cutter::ball(1)).size(), 3U);
    path.points[0].move = Move::Rapid;
    EXPECT_EQ(path_sweeps(path, Cutter::ball(1)).size(), 2U);
    path.points[1].location.axis = Vec3::UnitX();
    EXPECT_THROW(path_sweeps(path, Cutter::ball(1)), GeometryError);
}

TEST(StockHistory, HasTheSweepsOfItsPaths)
{
    const ToolPath cut = test::tip_path({{0, 0, 0}, {1, 2, 3}, {4, 5, 6}});
    ToolPath rapid = cut;
    rapid.points.front().move = Move::Rapid;
    const Cutter ball = Cutter::ball(2);
    const Cutter flat = Cutter::flat(3);
    const StockHistory history{{}, {run_along(cut, ball), run_along(rapid, flat)}};
    std::vector<StraightSweep> expected = path_sweeps(cut, ball);
    for (const StraightSweep& sweep : path_sweeps(rapid, flat))
        expected.push_back(sweep);
    const std::vector<StraightSweep> found = history_sweeps(history);
    ASSERT_EQ(found.size(), expected.size());
    EXPECT_EQ(sweep_count(history), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k)
        expect_same(found[k], expected[k]);
}

TEST(StockHistory, OfNothingHasNoSweeps)
{
    const StockHistory history{{}, {{Cutter::ball(1), true, {}}}};
    EXPECT_EQ(sweep_count(history), 0U);
    EXPECT_TRUE(history_sweeps(history).empty());
    EXPECT_TRUE(run_along({}, Cutter::ball(1)).tips.empty());
}

TEST(JoinedSweeps, NumberThePointsOfThePath)
{
    const ToolPath earlier = test::tip_path({{0, 0, 0}, {1, 0, 0}});
    ToolPath path = test::tip_path({{0, 0, 1}, {1, 0, 1}, {2, 0, 1}});
    path.points.front().move = Move::Rapid;
    const StockHistory history{{}, {run_along(earlier, Cutter::flat(3))}};
    const JoinedSweeps joined{&history, path, Cutter::ball(2)};
    // the cutter's volume at the first point, one move of the earlier run, and two moves
    // of the path
    ASSERT_EQ(joined.all().size(), 4U);
    EXPECT_EQ(joined.earlier(), 2U);
    EXPECT_EQ(joined.own().size(), 2U);
    EXPECT_EQ(joined.point_of(-1), -1);
    EXPECT_EQ(joined.point_of(1), by_earlier_run);
    EXPECT_EQ(joined.point_of(2), 1);
    EXPECT_EQ(joined.point_of(3), 2);
    const JoinedSweeps alone{nullptr, path, Cutter::ball(2)};
    EXPECT_EQ(alone.earlier(), 0U);
    EXPECT_EQ(alone.point_of(0), 1);
}

TEST(TurningHistory, OfARunIsThePartOfThePath)
{
    ToolPath path = test::tip_path({{0, 0, 0}, {1, 0, 0}, {2, 0, 1}, {3, 0, 1}});
    const EarlierTurningRun run =
        turning_run_along(path, 1, 4, CuttingBody{Cutter::ball(2), 9}, true);
    ASSERT_EQ(run.poses.size(), 3U);
    EXPECT_EQ(run.poses[0].tip, (Vec3{1, 0, 0}));
    EXPECT_EQ(run.poses[2].axis, Vec3::UnitZ());
    EXPECT_EQ(run.cutter.length(), 9);
    EXPECT_FALSE(run.machine);
    EXPECT_EQ(motion_count({{}, {run}}), 3U);
    MachineMotion motion;
    motion.positions.resize(4);
    motion.positions[2].rotary[0] = 0.5;
    path.machine = motion;
    const EarlierTurningRun turned =
        turning_run_along(path, 2, 4, CuttingBody{Cutter::ball(2)}, false);
    ASSERT_EQ(turned.machine->positions.size(), 2U);
    EXPECT_EQ(turned.machine->positions[0].rotary[0], 0.5);
    EXPECT_EQ(motion_count({{}, {turned}}), 1U);
}

TEST(TurningHistory, OfHeightsHasTheSameMotions)
{
    const ToolPath path = test::tip_path({{0, 0, 0}, {1, 0, 0}, {2, 0, 1}});
    const StockHistory history{{{0, 0, 0}, {1, 1, 1}},
                               {run_along(path, Cutter::flat(3))}};
    const TurningHistory turning = turning_history(history);
    EXPECT_EQ(turning.block.high, history.block.high);
    ASSERT_EQ(turning.runs.size(), 1U);
    EXPECT_EQ(motion_count(turning), sweep_count(history));
    EXPECT_EQ(turning.runs[0].poses[1].tip, history.runs[0].tips[1]);
}

}  // namespace
}  // namespace endmill
