// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/part_gap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "endmill/stock/stock_history.h"
#include "test_surfaces.h"
#include "tip_path.h"

namespace endmill {
namespace {

double gap_between_plane_and(const Vec3& tip)
{
    const Part part = std::vector<Surface>{test::plane(20, 12)};
    const PartCharts charts = part_charts(part);
    const std::vector<StraightSweep> sweeps =
        path_sweeps(test::tip_path({tip}), Cutter::ball(5));
    return part_gap(charts, SweepTree{sweeps});
}

TEST(PartGap, IsACloseLowerBoundOfTheDistance)
{
    EXPECT_LE(gap_between_plane_and({10, 6, 30}), 30);
    EXPECT_GE(gap_between_plane_and({10, 6, 30}), 29.5);
    const double truth = std::hypot(20, 5) - 5;  // from the centre to the nearest edge
    EXPECT_LE(gap_between_plane_and({40, 6, 0}), truth);
    EXPECT_GE(gap_between_plane_and({40, 6, 0}), truth - 0.5);
    EXPECT_EQ(gap_between_plane_and({10, 6, 0}), 0);
}

TEST(PartGap, WithoutMovesIsInfinite)
{
    const Part part = std::vector<Surface>{test::plane(20, 12)};
    EXPECT_TRUE(std::isinf(
        part_gap(part_charts(part), SweepTree{std::span<const StraightSweep>{}})));
}

bool passes_over_plane(const Cutter& cutter, const std::vector<Vec3>& tips, double top)
{
    const Part part = std::vector<Surface>{test::plane(20, 12)};
    const PartCharts charts = part_charts(part);
    const std::vector<StraightSweep> sweeps = path_sweeps(test::tip_path(tips), cutter);
    return passes_over(charts, SweepTree{sweeps}, top);
}

// The cutter overlaps the border or a corner of the part by a little, passes over the
// part, or stays above the stock.
TEST(PassesOver, IsTrueWhereverTheCutterReachesThePart)
{
    for (const double in : {0.02, 0.5, 8.0}) {
        const std::vector<Vec3> tips{{-5 + in, -3, -2}, {-5 + in, 20, -2}};
        EXPECT_TRUE(passes_over_plane(Cutter::flat(5), tips, 1)) << in;
        // The ball's surface is R - sqrt(R^2 - d^2) above its tip there.
        const double rise = 5 - std::sqrt(25 - (5 - in) * std::max(0.0, 5 - in));
        EXPECT_FALSE(passes_over_plane(Cutter::ball(5), tips, -2 + rise - 0.01));
        EXPECT_TRUE(passes_over_plane(Cutter::ball(5), tips, -2 + rise + 0.1)) << in;
    }
    const double at_corner = -std::sqrt(12.5);
    EXPECT_TRUE(
        passes_over_plane(Cutter::flat(5), {{at_corner + 0.02, at_corner + 0.02, 0}}, 1));
    EXPECT_FALSE(
        passes_over_plane(Cutter::flat(5), {{at_corner - 0.02, at_corner - 0.02, 0}}, 1));
    EXPECT_FALSE(
        passes_over_plane(Cutter::flat(5), {{-5.001, -3, -2}, {-5.001, 20, -2}}, 1));
    EXPECT_FALSE(passes_over_plane(Cutter::flat(5), {{0, 0, 1}, {20, 0, 1}}, 1));
    EXPECT_FALSE(passes_over_plane(Cutter::flat(5), {}, 1));
}

}  // namespace
}  // namespace endmill
