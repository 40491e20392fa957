// SPDX-License-Identifier: GPL-3.0-or-later
// Whole plans on scaled, closed, pinched and divided parts, and known lengths.

#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/planning/planner_options.h"
#include "endmill/planning/verified_plan.h"
#include "endmill/strategy/strategy.h"
#include "endmill/surface/nurbs.h"
#include "revolved_surfaces.h"
#include "test_meshes.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

StrategyPlan plan_of(const std::vector<Surface>& surfaces, Strategy strategy,
                     double radius, double height, double tolerance = 0.01)
{
    StrategyOptions options;
    options.scallop_height = height;
    options.inner_tolerance = tolerance;
    options.link.safe_height = default_safe_height(surfaces, Vec3::UnitZ());
    return plan_by_strategy(strategy, surfaces, BallCutter{radius}, options);
}

void expect_covered(const StrategyPlan& plan)
{
    EXPECT_EQ(plan.verdict, Verdict::Clean);
    EXPECT_TRUE(plan.covering.uncovered.empty());
    EXPECT_EQ(plan.covering.uncovered_mm2, 0);
}

// If the part, the ball, the height and the tolerance are twice as large, the path is twice as
// long.
TEST(StrategyOnAScaledPart, TravelsInProportion)
{
    for (const Strategy strategy : every_strategy) {
        const StrategyPlan small =
            plan_of({test::saddle(32, 15)}, strategy, 5, 0.4, 0.01);
        const StrategyPlan large =
            plan_of({test::saddle(64, 30)}, strategy, 10, 0.8, 0.02);
        expect_covered(small);
        expect_covered(large);
        const Travel& travel = small.economy.cut;
        EXPECT_NEAR(large.economy.cut.contact_mm / travel.contact_mm, 2, 0.02)
            << strategy_name(strategy);
        EXPECT_NEAR(large.economy.cut.tip_mm / travel.tip_mm, 2, 0.02)
            << strategy_name(strategy);
    }
}

// The lengths of an earlier, independent program. By contacts passes along v are shorter, by
// tips those along u.
TEST(PathsAlongParameters, OfASaddleAreInAnotherOrderByContactsThanByTips)
{
    const std::vector<Surface> saddle{test::saddle(32, 45, {3, 3})};
    VerifiedOptions options;
    options.tolerances = {0.01, 0.01};
    options.scallop_height = 0.5;
    options.link.safe_height = default_safe_height(saddle, Vec3::UnitZ());
    const auto travel = [&](Parameter along) {
        options.direction = along;
        const PathEconomy economy =
            path_economy(plan_verified(saddle, BallCutter{7.5}, options).path);
        return Travel{economy.cut.contact_mm + economy.link.contact_mm,
                      economy.cut.tip_mm + economy.link.tip_mm};
    };
    const Travel u = travel(Parameter::U);
    const Travel v = travel(Parameter::V);
    constexpr double share = 0.01;
    EXPECT_NEAR(u.contact_mm, 2743.2, share * 2743.2);
    EXPECT_NEAR(v.contact_mm, 2626.0, share * 2626.0);
    EXPECT_NEAR(u.tip_mm, 2464.0, share * 2464.0);
    EXPECT_NEAR(v.tip_mm, 2871.8, share * 2871.8);
    EXPECT_GT(u.contact_mm, v.contact_mm);
    EXPECT_LT(u.tip_mm, v.tip_mm);
}

class StrategyOnAClosedPart : public testing::TestWithParam<Strategy> {};

// The upper part of a torus, which is closed around its axis.
TEST_P(StrategyOnAClosedPart, CoversARing)
{
    expect_covered(plan_of(
        {nurbs_surface(test::torus(14, 6, {0, 2 * std::numbers::pi, 0.8, 2.4, 4}))},
        GetParam(), 4, 0.4));
}

// An arch of 143 degrees.
TEST_P(StrategyOnAClosedPart, CoversAnArch)
{
    expect_covered(plan_of({nurbs_surface(test::cylinder(10, 30, 0.32, 2.82, 2))},
                           GetParam(), 4, 0.4));
}

INSTANTIATE_TEST_SUITE_P(OfEachKind, StrategyOnAClosedPart,
                         testing::Values(Strategy::Planar, Strategy::IsoScallop));

// Two squares of 20 mm, joined by a neck of 2 mm by 10 mm, which is narrower than a strip.
TEST(StrategyOnADumbBell, CoversBothEndsAndTheNeck)
{
    std::vector<Vec3> points;
    for (const double x : {0.0, 20.0, 30.0, 50.0})
        for (const double y : {0.0, 9.0, 11.0, 20.0})
            points.emplace_back(x, y, 0);
    std::vector<Triangle> triangles;
    const auto add_cell = [&](int column, int row) {
        const int low = 4 * column + row;
        triangles.push_back({low, low + 4, low + 5});
        triangles.push_back({low, low + 5, low + 1});
    };
    for (const int column : {0, 2})
        for (int row = 0; row < 3; ++row)
            add_cell(column, row);
    add_cell(1, 1);
    const TriangleMesh mesh{points, triangles};
    StrategyOptions options;
    options.scallop_height = 0.5;
    options.link.safe_height = 5;
    for (const Strategy strategy : {Strategy::Planar, Strategy::IsoScallop}) {
        const StrategyPlan plan =
            plan_by_strategy(strategy, mesh, BallCutter{5}, options);
        expect_covered(plan);
        EXPECT_EQ(plan.covering.unreached_mm2, 0);
    }
}

// A plane triangle, as a patch of which one side is a point. The normal has a limit there.
TEST(StrategyOnACollapsedPatch, CoversTheCorner)
{
    const Surface triangle{
        {0, 1},
        {0, 1},
        {BezierPatch{1, 1,
                     std::vector<Vec3>{{0, 0, 0}, {30, 0, 0}, {0, 20, 0}, {0, 20, 0}}}}};
    for (const Strategy strategy : {Strategy::Planar, Strategy::IsoScallop})
        expect_covered(plan_of({triangle}, strategy, 5, 0.5));
}

}  // namespace
}  // namespace endmill
