// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/simulation/part_gap.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

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

TEST(PartGap, IsNearlyTheDistanceAndNeverMore)
{
    EXPECT_LE(gap_between_plane_and({10, 6, 30}), 30);
    EXPECT_GE(gap_between_plane_and({10, 6, 30}), 29.5);
    const double truth = std::hypot(20, 5) - 5;  // from the centre to the nearest edge
    EXPECT_LE(gap_between_plane_and({40, 6, 0}), truth);
    EXPECT_GE(gap_between_plane_and({40, 6, 0}), truth - 0.5);
    EXPECT_EQ(gap_between_plane_and({10, 6, 0}), 0);
}

TEST(PartGap, OfNothingIsInfinite)
{
    const Part part = std::vector<Surface>{test::plane(20, 12)};
    EXPECT_TRUE(std::isinf(
        part_gap(part_charts(part), SweepTree{std::span<const StraightSweep>{}})));
}

}  // namespace
}  // namespace endmill
