// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/plane_gaps.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/drop_cutter/clearance.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

using Lines = std::vector<std::vector<Vec3>>;

const std::vector<Surface> level{test::plane(40, 20)};

// Above the level plane z = 0 the gap of a ball is the height of its centre minus R.
TEST(PlaneGaps, AboveALevelPartAreTheHeights)
{
    const std::vector<Lines> planes{
        {{{5, 5, 3.5}, {10, 5, 4}}, {{20, 5, 3.25}}},  // 0.25 mm clear
        {},
        {{{5, 10, 2.9}, {10, 10, 3}}},    // 0.1 mm deep
        {{{5, 15, 2.99}}, {{10, 15, 5}}}  // 0.01 mm deep
    };
    const PlaneGaps gaps = plane_gaps(level, Cutter::ball(3), planes, 0.05);
    EXPECT_EQ(gaps.points, 7U);
    EXPECT_NEAR(gaps.least, -0.1, gap_resolution);
    EXPECT_EQ(gaps.gouging_planes, 1U);
    EXPECT_EQ(plane_gaps(level, Cutter::ball(3), planes, 0.005).gouging_planes, 2U);
    EXPECT_EQ(plane_gaps(level, Cutter::ball(3), planes, 0.2).gouging_planes, 0U);
}

TEST(PlaneGaps, WithoutAPositionAreInfinite)
{
    const PlaneGaps gaps = plane_gaps(level, Cutter::flat(3), {}, 0);
    EXPECT_EQ(gaps.points, 0U);
    EXPECT_TRUE(std::isinf(gaps.least));
    EXPECT_EQ(gaps.gouging_planes, 0U);
}

}  // namespace
}  // namespace endmill
