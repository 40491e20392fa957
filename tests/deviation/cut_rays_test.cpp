// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/cut_rays.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/stock/stock_history.h"
#include "random.h"
#include "tip_path.h"

namespace endmill {
namespace {

class CutRaysOf : public testing::TestWithParam<Cutter> {};

// The tree, the half spaces and the rays that are cut first must not change the result.
TEST_P(CutRaysOf, AreTheMinimumOverAllSweeps)
{
    test::Random random{21};
    const auto uniform = [&](double size) {
        return Vec3{random.uniform(-size, size), random.uniform(-size, size),
                    random.uniform(-size, size)};
    };
    for (int round = 0; round < 60; ++round) {
        std::vector<Vec3> tips;
        for (int i = 0; i < 60; ++i)
            tips.push_back((i % 2 ? tips.back() : Vec3{uniform(12)}) + uniform(2));
        const std::vector<StraightSweep> sweeps =
            path_sweeps(test::tip_path(tips), GetParam());
        const SweepTree tree{sweeps};
        const Vec3 centre = uniform(8);
        Vec3 normal = uniform(1);
        normal.z() = std::abs(normal.z());
        std::vector<PartRay> rays;
        for (int i = 0; i < 40; ++i)
            rays.push_back({centre + uniform(0.5), (normal + uniform(0.1)).normalized(),
                            Vec3::Zero(), Vec3::Zero()});
        const std::vector<double> lengths(rays.size(), 15);
        CutRays cut{rays, lengths};
        cut.cut(tree);
        for (std::size_t k = 0; k < rays.size(); ++k) {
            double least = 15;
            for (const StraightSweep& sweep : sweeps)
                if (const auto left = cut_ray(sweep, rays[k]))
                    least = std::min(least, left->thickness);
            EXPECT_NEAR(cut[static_cast<int>(k)].thickness, least, 1e-10);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(BallFlatBull, CutRaysOf,
                         testing::Values(Cutter::ball(5), Cutter::flat(5), Cutter{5, 2}));

// The same with one tree for all cutters.
TEST(CutRays, OfSeveralCuttersAreTheMinimumOverAllSweeps)
{
    test::Random random{23};
    const auto uniform = [&](double size) {
        return Vec3{random.uniform(-size, size), random.uniform(-size, size),
                    random.uniform(-size, size)};
    };
    const Cutter cutters[] = {Cutter::ball(1), Cutter::flat(6), Cutter{4, 3}};
    for (int round = 0; round < 60; ++round) {
        std::vector<StraightSweep> sweeps;
        for (int i = 0; i < 60; ++i) {
            const Vec3 from = uniform(12);
            sweeps.emplace_back(cutters[i % 3], from, from + uniform(2));
        }
        const SweepTree tree{sweeps};
        std::vector<CutRays> tiles;
        std::vector<std::vector<PartRay>> rays;
        for (int t = 0; t < 4; ++t) {
            const Vec3 centre = Vec3{1.0 * t, 0, 0} + uniform(0.5);
            rays.emplace_back();
            for (int i = 0; i < 20; ++i)
                rays.back().push_back({centre + uniform(0.5),
                                       (Vec3::UnitZ() + uniform(0.3)).normalized(),
                                       Vec3::Zero(), Vec3::Zero()});
            tiles.emplace_back(rays.back(), std::vector<double>(20, 15.0));
        }
        CutRays alone{rays[0], std::vector<double>(20, 15.0)};
        alone.cut(tree);
        std::vector<CutRays*> all;
        for (CutRays& tile : tiles)
            all.push_back(&tile);
        CutRays::cut_together(all, tree);
        for (std::size_t t = 0; t < tiles.size(); ++t)
            for (std::size_t k = 0; k < rays[t].size(); ++k) {
                double least = 15;
                for (const StraightSweep& sweep : sweeps)
                    if (const auto left = cut_ray(sweep, rays[t][k]))
                        least = std::min(least, left->thickness);
                const int number = static_cast<int>(k);
                EXPECT_NEAR(tiles[t][number].thickness, least, 1e-10);
                if (t == 0) {
                    EXPECT_NEAR(alone[number].thickness, least, 1e-10);
                }
            }
    }
}

// Every sweep that clears a place of the part near a ray must be listed.
TEST(CutRays, NameTheSweepsThatGougeThePart)
{
    test::Random random{22};
    for (const Cutter& cutter : {Cutter::ball(2), Cutter::flat(2), Cutter{2, 0.5}}) {
        std::vector<Vec3> tips;
        for (int i = 0; i < 400; ++i)
            tips.emplace_back(random.uniform(-9, 9), random.uniform(-9, 9),
                              random.uniform(-0.5, 2));
        const std::vector<StraightSweep> sweeps =
            path_sweeps(test::tip_path(tips), cutter);
        const SweepTree tree{sweeps};
        std::vector<PartRay> rays;
        for (int i = 0; i < 16; ++i)
            rays.push_back({{0.25 * (i % 4), 0.25 * (i / 4), 0},
                            Vec3::UnitZ(),
                            Vec3::UnitX(),
                            Vec3::UnitY()});
        const std::vector<double> lengths(rays.size(), 3);
        CutRays cut{rays, lengths};
        const auto gouging = cut.gouging_sweeps(tree, 0.18, 0);
        EXPECT_LT(gouging.size(), sweeps.size());
        for (std::size_t k = 0; k < sweeps.size(); ++k) {
            bool is_under = false;
            for (int i = -3; i <= 27; ++i)
                for (int j = -3; j <= 27; ++j)
                    is_under = is_under || sweeps[k].height(i / 32.0, j / 32.0) < -1e-9;
            if (is_under) {
                EXPECT_TRUE(
                    std::ranges::binary_search(gouging, static_cast<std::int32_t>(k)));
            }
        }
        cut.cut(tree);
        EXPECT_EQ(cut.gouging_sweeps(tree, 0.18, 0), gouging);
    }
}

}  // namespace
}  // namespace endmill
