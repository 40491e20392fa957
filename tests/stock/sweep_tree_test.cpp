// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/sweep_tree.h"

#include <optional>
#include <set>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/stock/stock_history.h"
#include "random.h"
#include "tip_path.h"

namespace endmill {
namespace {

// Reference: every sweep is tested.
TEST(SweepTree, VisitsEverySweepWithinReach)
{
    test::Random random{5};
    std::vector<Vec3> tips;
    for (int i = 0; i < 400; ++i)
        tips.emplace_back(random.uniform(0, 90), random.uniform(0, 90),
                          random.uniform(0, 9));
    const std::vector<StraightSweep> sweeps =
        path_sweeps(test::tip_path(tips), Cutter::ball(2));
    const SweepTree tree{sweeps};
    for (int i = 0; i < 50; ++i) {
        const Vec3 place{random.uniform(0, 90), random.uniform(0, 90),
                         random.uniform(0, 9)};
        std::set<std::size_t> visited;
        tree.visit(
            place, [&](const Vec3& nearest) { return (nearest - place).norm() <= 3; },
            [&](std::size_t number) { visited.insert(number); });
        for (std::size_t k = 0; k < sweeps.size(); ++k) {
            double distance = 1e9;
            for (int s = 0; s <= 100; ++s) {
                Vec3 away = sweeps[k].from() + Vec3{0, 0, 2} - place +
                            s / 100.0 * (sweeps[k].to() - sweeps[k].from());
                away.z() = std::max(away.z(), 0.0);
                distance = std::min(distance, away.norm());
            }
            if (distance <= 3) {
                EXPECT_TRUE(visited.contains(k)) << k;
            }
        }
        EXPECT_LT(visited.size(), sweeps.size());
    }
}

TEST(SweepTree, WithoutSweepsVisitsNothing)
{
    const SweepTree tree{std::span<const StraightSweep>{}};
    tree.visit(
        Vec3::Zero(), [](const Vec3&) { return true; }, [](std::size_t) { FAIL(); });
}

// Each box belongs to one cutter, which is passed with it, and every sweep lies in some
// box.
TEST(SweepTree, NamesTheCutterOfItsBoxes)
{
    const Cutter cutters[] = {Cutter{5, 1}, Cutter::ball(3), Cutter::flat(2)};
    std::vector<StraightSweep> sweeps;
    for (int i = 0; i < 90; ++i)
        sweeps.emplace_back(cutters[i % 3], Vec3{1.0 * i, 0, 0}, Vec3{1.0 * i, 5, 0});
    const SweepTree tree{sweeps};
    EXPECT_FALSE(tree.is_of_one_cutter());
    EXPECT_EQ(tree.least_corner_radius(), 0);
    std::set<std::size_t> visited;
    std::optional<Cutter> named;
    std::vector<Cutter> order;
    tree.visit(
        {0, 0, 0},
        [&](const Vec3&, const Cutter& cutter) {
            if (!named || !(*named == cutter))
                order.push_back(cutter);
            named = cutter;
            return true;
        },
        [&](std::size_t number) {
            EXPECT_EQ(sweeps[number].cutter(), *named);
            visited.insert(number);
        });
    EXPECT_EQ(visited.size(), sweeps.size());
    EXPECT_EQ(order, (std::vector<Cutter>{cutters[2], cutters[1], cutters[0]}));
}

TEST(SweepTree, ReportsASingleCutter)
{
    const std::vector<StraightSweep> sweeps =
        path_sweeps(test::tip_path({{0, 0, 0}, {1, 0, 0}}), Cutter{0.3, 0.1});
    EXPECT_TRUE(SweepTree{sweeps}.is_of_one_cutter());
    EXPECT_EQ(SweepTree{sweeps}.least_corner_radius(), 0.1);
    EXPECT_EQ(SweepTree{{}}.least_corner_radius(), 0);
}

}  // namespace
}  // namespace endmill
