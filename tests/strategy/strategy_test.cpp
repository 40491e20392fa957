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

StrategyPlan iso_scallop(const std::vector<Surface>& surfaces, double radius,
                         const StrategyOptions& options)
{
    return plan_by_strategy(Strategy::IsoScallop, surfaces, BallCutter{radius}, options);
}

// On a plane the strip of a pass is 6 mm wide; 40 mm need at least 7 passes.
TEST(PlanIsoScallop, CoversAPlaneWithAsFewPassesAsStripsFit)
{
    const std::vector<Surface> surfaces{test::plane(60, 40)};
    const StrategyOptions options = options_for(surfaces, 1);
    const StrategyPlan plan = iso_scallop(surfaces, 5, options);
    EXPECT_TRUE(plan.covering.uncovered.empty());
    EXPECT_EQ(plan.covering.pieces, 7u);
    EXPECT_LE(plan.economy.cut.contact_mm, 7 * 60 + 0.1);
    EXPECT_EQ(plan.verdict, Verdict::Clean);
}

// What the verifier measures shares no code with the plan.
TEST(PlanIsoScallop, IsJudgedCleanOnCurvedSurfaces)
{
    for (const Surface& surface :
         {test::saddle(60, 25), test::parabolic_cylinder(1.0 / 60, 20, 30)}) {
        const std::vector<Surface> surfaces{surface};
        const StrategyOptions options = options_for(surfaces, 0.3);
        const StrategyPlan plan = iso_scallop(surfaces, 4, options);
        EXPECT_TRUE(plan.covering.uncovered.empty());
        EXPECT_EQ(plan.verdict, Verdict::Clean);
    }
}

TEST(PlanIsoScallop, DoesNotDependOnTheNumberOfThreads)
{
    const std::vector<Surface> surfaces{test::saddle(60, 20)};
    const StrategyOptions options = options_for(surfaces, 0.5);
    set_thread_count(1);
    const StrategyPlan one = iso_scallop(surfaces, 5, options);
    set_thread_count(3);
    const StrategyPlan three = iso_scallop(surfaces, 5, options);
    ASSERT_EQ(one.covering.path.points.size(), three.covering.path.points.size());
    for (std::size_t k = 0; k < one.covering.path.points.size(); ++k)
        EXPECT_EQ(one.covering.path.points[k].location.tip,
                  three.covering.path.points[k].location.tip);
}

TEST(PlanIsoScallop, RefusesWhatItCannotPlan)
{
    const std::vector<Surface> surfaces{test::plane(60, 40)};
    StrategyOptions options = options_for(surfaces, 6);
    EXPECT_THROW(iso_scallop(surfaces, 5, options), DomainError);
    options = options_for(surfaces, 1);
    options.inner_tolerance = 0;
    EXPECT_THROW(iso_scallop(surfaces, 5, options), DomainError);
    options = options_for(surfaces, 1e-6);
    options.most_samples = 10'000;
    EXPECT_THROW(iso_scallop(surfaces, 5, options), LimitError);
}

}  // namespace
}  // namespace endmill
