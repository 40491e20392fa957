// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/strategy.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/planning/economy.h"
#include "endmill/planning/planner_options.h"
#include "endmill/surface/sampling.h"
#include "endmill/surface/tool_side.h"
#include "endmill/verification/verification.h"
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

StrategyPlan on_mesh(const TriangleMesh& mesh, const BallCutter& ball, double height,
                     Strategy strategy = Strategy::IsoScallop,
                     TravelKind distance = TravelKind::Contact)
{
    StrategyOptions options;
    options.distance = distance;
    options.scallop_height = height;
    options.link.safe_height = 60;
    return plan_by_strategy(strategy, mesh, ball, options);
}

void expect_covered(const StrategyPlan& plan)
{
    EXPECT_EQ(plan.verdict, Verdict::Clean);
    EXPECT_TRUE(plan.covering.uncovered.empty());
    EXPECT_EQ(plan.covering.uncovered_mm2, 0);
}

// A path over the mesh of a smooth surface is as long as one over the surface. By contacts
// both directions of the saddle are about equally good, by tips one is better.
TEST(StrategyOnAMesh, CutsASmoothPartAsItsSurface)
{
    const std::vector<Surface> surfaces{test::saddle(60, 20)};
    StrategyOptions options = options_for(surfaces, 0.5);
    options.distance = TravelKind::Tip;
    const StrategyPlan on_surface = iso_scallop(surfaces, 5, options);
    const std::vector<double> sides = tool_side_signs(surfaces, Vec3::UnitZ());
    const StrategyPlan plan = on_mesh(sampled(surfaces, sides, 0.01).mesh, BallCutter{5},
                                      0.5, Strategy::IsoScallop, TravelKind::Tip);
    expect_covered(plan);
    EXPECT_EQ(plan.covering.unreached_mm2, 0);
    EXPECT_NEAR(plan.economy.cut.contact_mm / on_surface.economy.cut.contact_mm, 1,
                0.015);
    EXPECT_NEAR(plan.economy.cut.tip_mm / on_surface.economy.cut.tip_mm, 1, 0.015);
}

// A ring between the radii 5 and 25: no cut leads over the hole.
TEST(StrategyOnAMesh, LeadsNoCutOverAHole)
{
    const TriangleMesh ring = test::grid_mesh(48, 4, [](int i, int j) {
        const double angle = -2 * std::numbers::pi * i / 48;
        return Vec3{(5 + 5 * j) * std::cos(angle), (5 + 5 * j) * std::sin(angle), 0};
    });
    const StrategyPlan plan = on_mesh(ring, BallCutter{5}, 0.5);
    expect_covered(plan);
    const std::vector<PathPoint>& points = plan.covering.path.points;
    for (std::size_t k = 1; k < points.size(); ++k)
        if (points[k].move == Move::Cut) {
            const Vec3 middle = (points[k - 1].location.tip + points[k].location.tip) / 2;
            // a side of the polygon of 48 corners is 0.01 mm inside its circle
            EXPECT_GT(middle.head<2>().norm(), 4.95);
        }
}

TEST(StrategyOnAMesh, CoversPartsThatAreApart)
{
    const TriangleMesh one = test::flat_mesh(20, 20);
    std::vector<Vec3> moved = test::points_of(one);
    for (Vec3& point : moved)
        point.x() += 50;
    const TriangleMesh two = test::both(one, {moved, test::triangles_of(one)});
    for (const Strategy strategy : {Strategy::IsoScallop, Strategy::Planar}) {
        const StrategyPlan plan = on_mesh(two, BallCutter{5}, 0.5, strategy);
        expect_covered(plan);
        EXPECT_GE(plan.covering.pieces, 2u);
    }
}

// All five faces of a box that do not face down. The shank passes along the walls, so no
// move may enter them.
TEST(StrategyOnAMesh, CutsTheWallsOfASolid)
{
    const StrategyPlan plan =
        on_mesh(test::box_mesh({0, 0, 0}, {20, 15, 8}), BallCutter{4}, 0.3);
    expect_covered(plan);
    EXPECT_EQ(plan.deviation.max_gouge_mm, 0);
    EXPECT_EQ(plan.covering.unreached_mm2, 0);
}

// In a groove of 90 degrees a ball that is h / 2 above a place of one plane is clear of the
// other if the place is at least R from the edge: the distance along one plane is the
// distance from the other.
TEST(StrategyOnAMesh, ReportsWhatTheBallCannotReach)
{
    const double radius = 4;
    const double height = 0.4;
    const double side = 15;
    const double up = side / std::sqrt(2.0);
    const TriangleMesh groove = test::grid_mesh(2, 1, [&](int i, int j) {
        return Vec3{(i - 1) * up, 20.0 * j, i == 1 ? 0.0 : up};
    });
    const StrategyPlan plan = on_mesh(groove, BallCutter{radius}, height);
    expect_covered(plan);
    const double expected = 2 * radius * 20;
    EXPECT_NEAR(plan.covering.unreached_mm2, expected, 0.01 * expected);
}

TEST(StrategyOnAMesh, RefusesAMeshThatFacesDownAndParameterLines)
{
    const TriangleMesh flat = test::flat_mesh(5, 5);
    EXPECT_THROW(on_mesh(test::with_turned(flat, [](std::size_t) { return true; }),
                         BallCutter{1}, 0.1),
                 GeometryError);
    EXPECT_THROW(on_mesh(flat, BallCutter{1}, 0.1, Strategy::IsoU), GeometryError);
}

// A strategy that is not planned has an estimate of its length. The best plan is not longer than
// that of any strategy by itself.
TEST(BestPlan, IsNotLongerThanThePlanOfAnyStrategy)
{
    const std::vector<Surface> surfaces{test::saddle(60, 20)};
    const BallCutter ball{5};
    const StrategyOptions options = options_for(surfaces, 0.3);
    const BestPlan best = plan_by_best_strategy(surfaces, ball, options);
    EXPECT_TRUE(best.plan.is_good());
    ASSERT_EQ(best.tried.size(), every_strategy.size());
    for (const TriedStrategy& one : best.tried) {
        EXPECT_NE(one.travel_mm.has_value(), one.estimated_mm.has_value());
        EXPECT_TRUE(one.refusal.empty());
        const StrategyPlan alone =
            plan_by_strategy(one.strategy, surfaces, ball, options);
        EXPECT_LE(best.plan.economy.cut.contact_mm, alone.economy.cut.contact_mm)
            << strategy_name(one.strategy);
    }
    EXPECT_TRUE(best.tried[0].travel_mm && best.tried[1].travel_mm)
        << "iso-u and iso-v are always planned";
}

// The width of a strip on a plane is 2 sqrt(h (2R - h)), so that a square of 20 mm has
// 400 / (4 h (2R - h)) squares of it.
double height_for_squares(double squares, double radius)
{
    const double half_square = 400 / squares / 4;
    return radius - std::sqrt(radius * radius - half_square);
}

TEST(BestPlan, LaysOneStrategyOnALargePart)
{
    const std::vector<Surface> surfaces{test::plane(20, 20)};
    const BallCutter ball{5};
    const BestPlan best = plan_by_best_strategy(
        surfaces, ball, options_for(surfaces, height_for_squares(4200, 5)));
    EXPECT_TRUE(best.plan.is_good());
    int laid = 0;
    for (const TriedStrategy& one : best.tried)
        if (one.strategy != Strategy::IsoU && one.strategy != Strategy::IsoV) {
            EXPECT_TRUE(one.travel_mm || one.estimated_mm || !one.refusal.empty());
            laid += one.travel_mm ? 1 : 0;
        }
    EXPECT_EQ(laid, 1);
}

TEST(BestPlan, FollowsParametersOnAVeryLargePart)
{
    const std::vector<Surface> surfaces{test::plane(20, 20)};
    const BallCutter ball{5};
    const StrategyOptions options = options_for(surfaces, height_for_squares(21'000, 5));
    const BestPlan best = plan_by_best_strategy(surfaces, ball, options);
    EXPECT_TRUE(best.plan.is_good());
    for (const TriedStrategy& one : best.tried) {
        const bool follows =
            one.strategy == Strategy::IsoU || one.strategy == Strategy::IsoV;
        EXPECT_EQ(one.travel_mm.has_value(), follows) << strategy_name(one.strategy);
        EXPECT_EQ(one.refusal.empty(), follows);
        if (follows) {
            EXPECT_LE(best.plan.economy.cut.contact_mm, *one.travel_mm);
        }
    }
}

}  // namespace
}  // namespace endmill
