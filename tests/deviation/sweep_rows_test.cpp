// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/sweep_rows.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <gtest/gtest.h>

#include "endmill/deviation/detail/cut_rays.h"
#include "endmill/stock/stock_history.h"
#include "random.h"
#include "tip_path.h"

namespace endmill {
namespace {

class SweepRowsOf : public testing::TestWithParam<Cutter> {};

Vec3 within(test::Random& random, double size)
{
    return {random.uniform(-size, size), random.uniform(-size, size),
            random.uniform(-size, size)};
}

// A sweep that is omitted for a tile shortens no ray of it. A sweep that is omitted for
// all rays is omitted for every tile.
TEST_P(SweepRowsOf, HoldEverySweepThatShortensARay)
{
    test::Random random{51};
    std::size_t kept = 0;
    std::size_t all = 0;
    for (int round = 0; round < 60; ++round) {
        std::vector<Vec3> tips;
        for (int i = 0; i < 80; ++i)
            tips.push_back((i % 2 ? tips.back() : within(random, 12)) +
                           within(random, i % 8 == 0 ? 0 : 2));
        const auto sweeps = path_sweeps(test::tip_path(tips), GetParam());
        const SweepTree tree{sweeps};
        std::vector<PartRay> rays;
        const Vec3 centre = within(random, 10);
        for (int i = 0; i < 30; ++i)
            rays.push_back({centre + within(random, 0.4),
                            (Vec3{0.3, 0, 1} + within(random, 0.2)).normalized(),
                            Vec3::Zero(), Vec3::Zero()});
        const std::vector<double> lengths(rays.size(), random.uniform(0, 3));
        const RayBounds bounds = CutRays{rays, lengths}.bounds();
        // Some sweeps are omitted for a larger tile first.
        RayBounds around = bounds;
        around.centre += within(random, 0.5);
        around.beside += 1;
        around.above += 1;
        std::vector<std::int32_t> near;
        for (const NearSweep& sweep :
             SweepRows{tree, around}.reduced(around).near(bounds))
            near.push_back(sweep.number);
        kept += near.size();
        all += sweeps.size();
        for (std::size_t k = 0; k < sweeps.size(); ++k) {
            if (std::ranges::find(near, static_cast<std::int32_t>(k)) != near.end())
                continue;
            for (const PartRay& ray : rays)
                EXPECT_FALSE(cut_ray(sweeps[k], ray, lengths[0])) << k;
        }
    }
    EXPECT_LT(kept, all / 2);
}

// The half space of a sweep contains all that the sweep clears: no place on a ray that the
// sweep reaches is outside.
TEST_P(SweepRowsOf, BoundWhatTheSweepsClear)
{
    test::Random random{53};
    int reached = 0;
    for (int round = 0; round < 60; ++round) {
        std::vector<Vec3> tips;
        for (int i = 0; i < 80; ++i)
            tips.push_back((i % 2 ? tips.back() : within(random, 8)) +
                           within(random, i % 8 == 0 ? 0 : 4));
        const auto sweeps = path_sweeps(test::tip_path(tips), GetParam());
        const SweepTree tree{sweeps};
        const RayBounds bounds{.centre = within(random, 6),
                               .upright = Vec3::UnitZ(),
                               .beside = 1,
                               .above = 1,
                               .tilt = 0,
                               .longest = 4};
        for (const NearSweep& near : SweepRows{tree, bounds}.near(bounds)) {
            const StraightSweep& sweep = sweeps[static_cast<std::size_t>(near.number)];
            for (int i = 0; i < 20; ++i) {
                Vec3 place = bounds.centre + within(random, 3);
                place.z() = sweep.height(place.x(), place.y());
                if (!std::isfinite(place.z()))
                    continue;
                ++reached;
                EXPECT_GE(near.half.normal.dot(place), near.half.least - 1e-11);
            }
            EXPECT_NEAR(near.half.normal.norm(), 1, 1e-12);
        }
    }
    EXPECT_GT(reached, 1000);
}

// Cutting tiles together gives the same result as cutting each alone.
TEST_P(SweepRowsOf, GiveTheSameResultTogether)
{
    test::Random random{52};
    for (int round = 0; round < 20; ++round) {
        std::vector<Vec3> tips;
        for (int i = 0; i < 100; ++i)
            tips.push_back(
                {random.uniform(-6, 6), random.uniform(-6, 6), random.uniform(0, 3)});
        const auto sweeps = path_sweeps(test::tip_path(tips), GetParam());
        const SweepTree tree{sweeps};
        std::vector<CutRays> tiles;
        for (int tile = 0; tile < 5; ++tile) {
            std::vector<PartRay> rays;
            for (int i = 0; i < 25; ++i)
                rays.push_back({{0.5 * tile + 0.1 * (i % 5), 0.1 * (i / 5), 0},
                                (Vec3::UnitZ() + within(random, 0.1)).normalized(),
                                Vec3::Zero(),
                                Vec3::Zero()});
            tiles.emplace_back(rays, std::vector<double>(rays.size(), 9));
        }
        std::vector<CutRays> alone = tiles;
        std::vector<CutRays*> together;
        for (CutRays& tile : tiles)
            together.push_back(&tile);
        CutRays::cut_together(together, tree);
        for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
            alone[tile].cut(tree);
            for (int k = 0; k < 25; ++k)
                EXPECT_NEAR(tiles[tile][k].thickness, alone[tile][k].thickness, 1e-11);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(BallFlatBull, SweepRowsOf,
                         testing::Values(Cutter::ball(3), Cutter::flat(3), Cutter{3, 1}));

TEST(SweepRows, OfNoSweepAreNone)
{
    const SweepTree tree{{}};
    const RayBounds rays{Vec3::Zero(), Vec3::UnitZ(), 1, 1, 0, 1};
    EXPECT_TRUE(SweepRows(tree, rays).near(rays).empty());
}

}  // namespace
}  // namespace endmill
