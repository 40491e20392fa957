// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/lay_by_strategy.h"

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/planning/economy.h"
#include "endmill/planning/planner_options.h"
#include "test_meshes.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr double height = 1;  // mm

StrategyOptions options_for(const std::vector<Surface>& surfaces)
{
    StrategyOptions options;
    options.scallop_height = height;
    options.link.safe_height = default_safe_height(surfaces, Vec3::UnitZ());
    return options;
}

TEST(WithProgress, ReportsAShareOfTheWhole)
{
    double reported = -1;
    StrategyOptions options;
    options.progress = [&](double share) { reported = share; };
    const StrategyOptions part = with_progress(options, 0.5, 0.75);
    part.progress(0);
    EXPECT_EQ(reported, 0.5);
    part.progress(0.5);
    EXPECT_EQ(reported, 0.625);
    part.progress(1);
    EXPECT_EQ(reported, 0.75);
    EXPECT_FALSE(with_progress(StrategyOptions{}, 0, 1).progress);
}

// A plane 40 mm wide needs at least 7 strips of 6 mm, or a little less at its borders.
TEST(CoveringBy, CoversAPlaneByEveryStrategy)
{
    const std::vector<Surface> surfaces{test::plane(60, 40)};
    const StrategyOptions options = options_for(surfaces);
    for (const Strategy strategy : every_strategy) {
        const CoveringPath path = covering_by(strategy, surfaces, BallCutter{5}, options);
        const double travel = path_economy(path.path).cut.contact_mm;
        EXPECT_GE(travel, 6 * 60) << strategy_name(strategy);
        // one line more where both borders have one
        EXPECT_LE(travel, 8 * 60 + 1e-9) << strategy_name(strategy);
        EXPECT_TRUE(path.uncovered.empty()) << strategy_name(strategy);
    }
}

TEST(CoveringBy, FollowsParametersOfSurfacesOnly)
{
    for (const Strategy strategy : every_strategy)
        EXPECT_EQ(follows_parameters(strategy),
                  strategy == Strategy::IsoU || strategy == Strategy::IsoV);
    EXPECT_THROW(covering_by(Strategy::IsoU, Part{test::box_mesh({0, 0, 0}, {9, 9, 9})},
                             BallCutter{2}, {}),
                 GeometryError);
}

TEST(CoveringBy, RefusesAnotherAxisOnSamples)
{
    const std::vector<Surface> surfaces{test::plane(60, 40)};
    StrategyOptions options = options_for(surfaces);
    options.link.axis = Vec3::UnitX();
    EXPECT_THROW(covering_by(Strategy::Planar, surfaces, BallCutter{5}, options),
                 GeometryError);
    EXPECT_THROW(covered_part(surfaces, BallCutter{5}, options), GeometryError);
}

// A given direction is laid without trials.
TEST(TrialsOf, HaveNoEstimateForAGivenDirection)
{
    const Part part = std::vector<Surface>{test::plane(60, 40)};
    StrategyOptions options = options_for(std::get<std::vector<Surface>>(part));
    options.direction = Angle::degrees(90);
    const CoveredPart covered = covered_part(part, BallCutter{5}, options);
    const Trials trials = trials_of(Strategy::Planar, part, covered, options);
    EXPECT_FALSE(trials.travel);
    const CoveringPath path = covering_after(trials, covered, options);
    ASSERT_TRUE(path.direction);
    EXPECT_EQ(path.direction->degrees(), 90);
    // eleven or so lines of 40 mm
    EXPECT_NEAR(path_economy(path.path).cut.contact_mm, 10.5 * 40, 25);
}

}  // namespace
}  // namespace endmill
