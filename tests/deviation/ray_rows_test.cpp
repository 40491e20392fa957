// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/ray_rows.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/deviation/detail/half_space.h"

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

RayRows rows_of(const std::vector<PartRay>& rays, double length)
{
    RayRows rows;
    rows.count = static_cast<int>(rays.size());
    for (std::size_t k = 0; k < most_tile_cells; ++k) {
        const PartRay& ray = rays[std::min(k, rays.size() - 1)];
        for (int c = 0; c < 3; ++c) {
            rows.point[static_cast<std::size_t>(c)][k] = ray.point[c];
            rows.normal[static_cast<std::size_t>(c)][k] = ray.normal[c];
        }
        rows.left[k] = k < rays.size() ? length : -infinite;
        rows.cosine[k] = 1;
        rows.sweep[k] = -1;
    }
    return rows;
}

TEST(RayRows, FallShortOfAHalfSpaceLikeTheirTips)
{
    const RayRows rows = rows_of({{{0, 0, 1}, {0, 0, 1}, Vec3::Zero(), Vec3::Zero()},
                                  {{0, 0, 2}, {0.6, 0, 0.8}, Vec3::Zero(), Vec3::Zero()}},
                                 0.5);
    RayRows::Row short_by;
    const HalfSpace over{{0, 0, 1}, 4};
    EXPECT_NEAR(shortfalls(rows, over, 0, 0, short_by), 1.6, 1e-12);
    EXPECT_NEAR(short_by[0], 2.5, 1e-12);
    EXPECT_NEAR(short_by[1], 1.6, 1e-12);
    EXPECT_NEAR(shortfalls(rows, over, 0.25, 0.125, short_by), 1.6 + 0.125 - 0.45, 1e-12);
}

TEST(RayRows, HaveTheLongestRay)
{
    const std::vector<PartRay> rays(
        11, {Vec3::Zero(), {0, 0, 1}, Vec3::Zero(), Vec3::Zero()});
    RayRows rows = rows_of(rays, -2);
    EXPECT_EQ(rows.padded(), 16);
    EXPECT_EQ(longest_left(rows), 0);
    rows.left[10] = 4;
    EXPECT_EQ(longest_left(rows), 4);
    EXPECT_EQ(greatest(rows.left, 8), 0);
}

}  // namespace
}  // namespace endmill
