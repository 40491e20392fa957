// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/strategy.h"

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/planning/economy.h"
#include "endmill/planning/planner_options.h"
#include "endmill/verification/verification.h"
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

Verdict judged(const std::vector<Surface>& surfaces, const StrategyPlan& plan,
               double radius, const StrategyOptions& options)
{
    const DeviationLimits limits{options.inner_tolerance, options.scallop_height};
    return verdict(deviation_of_path(surfaces, plan.path, Cutter::ball(radius),
                                     {limits, LimitProof::None, {}}),
                   limits);
}

// On a plane the strip of a pass is 6 mm wide; 40 mm need at least 7 passes.
TEST(PlanIsoScallop, CoversAPlaneWithAsFewPassesAsStripsFit)
{
    const std::vector<Surface> surfaces{test::plane(60, 40)};
    const StrategyOptions options = options_for(surfaces, 1);
    const StrategyPlan plan = plan_iso_scallop(surfaces, BallCutter{5}, options);
    EXPECT_TRUE(plan.uncovered.empty());
    EXPECT_EQ(plan.pieces, 7u);
    EXPECT_LE(path_economy(plan.path).cut.contact_mm, 7 * 60 + 0.1);
    EXPECT_EQ(judged(surfaces, plan, 5, options), Verdict::Clean);
}

// What the verifier measures shares no code with the plan.
TEST(PlanIsoScallop, IsJudgedCleanOnCurvedSurfaces)
{
    for (const Surface& surface :
         {test::saddle(60, 25), test::parabolic_cylinder(1.0 / 60, 20, 30)}) {
        const std::vector<Surface> surfaces{surface};
        const StrategyOptions options = options_for(surfaces, 0.3);
        const StrategyPlan plan = plan_iso_scallop(surfaces, BallCutter{4}, options);
        EXPECT_TRUE(plan.uncovered.empty());
        EXPECT_EQ(judged(surfaces, plan, 4, options), Verdict::Clean);
    }
}

TEST(PlanIsoScallop, DoesNotDependOnTheNumberOfThreads)
{
    const std::vector<Surface> surfaces{test::saddle(60, 20)};
    const StrategyOptions options = options_for(surfaces, 0.5);
    set_thread_count(1);
    const StrategyPlan one = plan_iso_scallop(surfaces, BallCutter{5}, options);
    set_thread_count(3);
    const StrategyPlan three = plan_iso_scallop(surfaces, BallCutter{5}, options);
    ASSERT_EQ(one.path.points.size(), three.path.points.size());
    for (std::size_t k = 0; k < one.path.points.size(); ++k)
        EXPECT_EQ(one.path.points[k].location.tip, three.path.points[k].location.tip);
}

TEST(PlanIsoScallop, RefusesWhatItCannotPlan)
{
    const std::vector<Surface> surfaces{test::plane(60, 40)};
    StrategyOptions options = options_for(surfaces, 6);
    EXPECT_THROW(plan_iso_scallop(surfaces, BallCutter{5}, options), DomainError);
    options = options_for(surfaces, 1);
    options.inner_tolerance = 0;
    EXPECT_THROW(plan_iso_scallop(surfaces, BallCutter{5}, options), DomainError);
    options = options_for(surfaces, 1e-6);
    options.most_samples = 10'000;
    EXPECT_THROW(plan_iso_scallop(surfaces, BallCutter{5}, options), LimitError);
}

}  // namespace
}  // namespace endmill
