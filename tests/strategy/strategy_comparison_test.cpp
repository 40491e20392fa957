// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/strategy_comparison.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/planning/economy.h"
#include "endmill/planning/planner_options.h"
#include "test_meshes.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

StrategyOptions options_for(const std::vector<Surface>& surfaces, double height)
{
    StrategyOptions options;
    options.scallop_height = height;
    options.link.safe_height = default_safe_height(surfaces, Vec3::UnitZ());
    return options;
}

// A ridge: passes around it are much longer than passes along it, or the other way.
TEST(StrategyComparison, LaysAndOrdersWhatMayBeShortest)
{
    const Part part = std::vector<Surface>{test::parabolic_cylinder(-1.0 / 20, 8, 40)};
    const StrategyOptions options =
        options_for(std::get<std::vector<Surface>>(part), 0.4);
    StrategyComparison comparison{part, BallCutter{5}, options};
    comparison.run();
    ASSERT_FALSE(comparison.candidates().empty());
    EXPECT_TRUE(std::ranges::is_sorted(comparison.candidates(), {}, &Candidate::travel));
    for (const Candidate& one : comparison.candidates()) {
        EXPECT_DOUBLE_EQ(path_economy(one.covering.path).cut.contact_mm, one.travel);
        EXPECT_EQ(comparison.tried(one.strategy).travel_mm, one.travel);
    }
    ASSERT_EQ(comparison.tried().size(), every_strategy.size());
    for (const TriedStrategy& one : comparison.tried())
        EXPECT_NE(one.travel_mm.has_value(), one.estimated_mm.has_value())
            << strategy_name(one.strategy);
}

// What was only estimated is laid on demand, each strategy once.
TEST(StrategyComparison, LaysTheRestOneByOne)
{
    const Part part = std::vector<Surface>{test::parabolic_cylinder(-1.0 / 20, 8, 40)};
    const StrategyOptions options =
        options_for(std::get<std::vector<Surface>>(part), 0.4);
    StrategyComparison comparison{part, BallCutter{5}, options};
    comparison.run();
    std::set<Strategy> laid;
    for (const Candidate& one : comparison.candidates())
        laid.insert(one.strategy);
    while (const std::optional<Candidate> next = comparison.next()) {
        EXPECT_TRUE(laid.insert(next->strategy).second) << strategy_name(next->strategy);
        EXPECT_GT(next->travel, 0);
    }
    EXPECT_EQ(laid.size(), every_strategy.size());
}

TEST(StrategyComparison, StatesWhyAStrategyIsRefused)
{
    const Part mesh = test::box_mesh({0, 0, 0}, {20, 20, 5});
    StrategyOptions options;
    options.scallop_height = 0.3;
    options.link.safe_height = 10;
    StrategyComparison comparison{mesh, BallCutter{4}, options};
    comparison.run();
    EXPECT_NE(comparison.tried(Strategy::IsoU).refusal.find("parameter lines"),
              std::string::npos);
    EXPECT_FALSE(comparison.tried(Strategy::IsoU).travel_mm);
    EXPECT_FALSE(comparison.candidates().empty());

    // a ball that is larger than the radius of the valley fits nowhere
    const Part valley = std::vector<Surface>{test::parabolic_cylinder(1.0 / 4, 8, 10)};
    const StrategyOptions own = options_for(std::get<std::vector<Surface>>(valley), 0.3);
    StrategyComparison none{valley, BallCutter{9}, own};
    EXPECT_THROW(none.run(), GeometryError);
}

// Strips of so small a height are refused at once, whatever lays them.
TEST(StrategyComparison, RefusesAHeightForWhichNothingWouldEnd)
{
    const Part part = std::vector<Surface>{test::plane(60, 40)};
    for (const double height : {1e-12, 1e-300}) {
        const StrategyOptions options =
            options_for(std::get<std::vector<Surface>>(part), height);
        StrategyComparison comparison{part, BallCutter{5}, options};
        EXPECT_THROW(comparison.run(), LimitError);
        for (const TriedStrategy& one : comparison.tried())
            EXPECT_NE(one.refusal.find("squares of a strip's width"), std::string::npos)
                << one.refusal;
    }
}

}  // namespace
}  // namespace endmill
