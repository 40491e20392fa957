// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/ball_rows.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/deviation/detail/cut_rays.h"
#include "random.h"

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

RayRows::Row all_may_be_shorter()
{
    RayRows::Row short_by;
    short_by.fill(-1);
    return short_by;
}

// Compares with the closed form for one ray. Moves are level, vertical, steep and without
// length; rays are vertical, level and oblique, above, inside and beside the swept
// volume.
void expect_as_one_by_one(const StraightSweep& sweep, const std::vector<PartRay>& rays,
                          double length)
{
    RayRows rows = rows_of(rays, length);
    shorten_by_ball(rows, sweep, 7, all_may_be_shorter());
    for (std::size_t k = 0; k < rays.size(); ++k) {
        const auto expected = cut_ray(sweep, rays[k], length);
        ASSERT_EQ(rows.sweep[k], expected ? 7 : -1)
            << k << ' ' << rays[k].point.transpose() << " along "
            << rays[k].normal.transpose();
        EXPECT_NEAR(rows.left[k], expected ? expected->thickness : length, 1e-9);
        if (expected && expected->slope < 10) {
            EXPECT_NEAR(std::abs(rows.cosine[k]), 1 / std::hypot(1, expected->slope),
                        1e-7);
        }
    }
}

TEST(ShortenByBall, EqualsShorteningOneByOne)
{
    test::Random random{31};
    const auto within = [&](double size) {
        return Vec3{random.uniform(-size, size), random.uniform(-size, size),
                    random.uniform(-size, size)};
    };
    const Vec3 moves[] = {{3, 1, 0}, {0, 0, -4}, {0, 0, 0}, {0.5, 0.2, 6}, {-2, 2, 1}};
    const Vec3 ways[] = {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}, {0.6, 0, 0.8}};
    for (int round = 0; round < 2000; ++round) {
        const Vec3 from = within(2);
        const StraightSweep sweep{Cutter::ball(3), from, from + moves[round % 5]};
        // A single ray is tested too, because the upright parts are computed for all rays
        // of a tile at once.
        const int count = round % 2 == 0 ? 1 : 37;
        std::vector<PartRay> rays;
        for (int i = 0; i < count; ++i) {
            Vec3 normal = i < 4 && count > 1 ? ways[i] : Vec3{within(1).normalized()};
            normal.z() = std::abs(normal.z());
            rays.push_back({within(6), normal, Vec3::Zero(), Vec3::Zero()});
        }
        expect_as_one_by_one(sweep, rays, random.uniform(0.1, 12));
    }
}

TEST(ShortenByBall, MeetsABallAtItsEndAlongTheMove)
{
    const StraightSweep sweep{Cutter::ball(3), {0, 0, -3}, {5, 0, -3}};
    RayRows rows = rows_of({{{-9, 0, 0}, {1, 0, 0}, Vec3::Zero(), Vec3::Zero()},
                            {{20, 0, 0}, {-1, 0, 0}, Vec3::Zero(), Vec3::Zero()}},
                           30);
    shorten_by_ball(rows, sweep, 0, all_may_be_shorter());
    EXPECT_NEAR(rows.left[0], 6, 1e-12);
    EXPECT_NEAR(rows.left[1], 12, 1e-12);
    EXPECT_NEAR(rows.cosine[0], -1, 1e-12);
}

TEST(ShortenByBall, LeavesOutRaysThatAreOutOfReach)
{
    const std::vector<PartRay> rays(
        9, {Vec3::Zero(), {0, 0, 1}, Vec3::Zero(), Vec3::Zero()});
    RayRows rows = rows_of(rays, 5);
    RayRows::Row short_by = all_may_be_shorter();
    short_by[4] = 0;
    shorten_by_ball(rows, StraightSweep{Cutter::ball(3), {0, 0, 1}, {1, 0, 1}}, 2,
                    short_by);
    for (std::size_t k = 0; k < 9; ++k)
        EXPECT_NEAR(rows.left[k], k == 4 ? 5 : 1, 1e-12);
    EXPECT_NEAR(longest_left(rows), 5, 1e-12);
}

}  // namespace
}  // namespace endmill
