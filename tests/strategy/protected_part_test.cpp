// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/protected_part.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/strategy/strategy.h"
#include "endmill/surface/tool_side.h"
#include "test_meshes.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr double tolerance = 0.01;
// That contacts keep from a protected mesh.
constexpr double distance = tolerance / 4;

// A box is entered where the ball is nearer to its wall than the radius.
TEST(ProtectedPart, IsEnteredByABallBesideAWallThatIsNearerThanItsRadius)
{
    const Part box = test::box_mesh({0, 0, 0}, {20, 20, 20});
    const ProtectedPart guard{box, BallCutter{3}, tolerance};
    EXPECT_TRUE(guard.is_clear(Vec3{-3 - 1.01 * distance, 10, 8}));
    EXPECT_FALSE(guard.is_clear(Vec3{-3 - 0.99 * distance, 10, 8}));
    // the shank of a ball below the box is in it
    EXPECT_FALSE(guard.is_clear(Vec3{10, 10, -50}));
    EXPECT_TRUE(guard.is_clear(Vec3{-50, 10, -50}));
    EXPECT_TRUE(guard.is_clear({-3.001, -40, 8}, {-3.001, 60, 8}));
    EXPECT_FALSE(guard.is_clear({-2.999, -40, 8}, {-2.999, 60, 8}));
    EXPECT_FALSE(guard.is_clear({-500, 10, 8}, {500, 10, 8}));
    EXPECT_TRUE(guard.is_clear({-500, 10, 23.001}, {500, 10, 23.001}));
    EXPECT_EQ(guard.highest(), 20);
}

// Over a floor at z = 0 the centre of a ball in contact at an angle is R cos(angle) high; it
// must rise to R and the distance that it keeps.
TEST(ProtectedPart, HoldsAContactOffALongItsNormal)
{
    const Part floor = test::flat_mesh(40, 40);
    const ProtectedPart guard{floor, BallCutter{3}, tolerance};
    const double angle = 0.1;
    const CutterContact contact{{20, 20, 0}, {std::sin(angle), 0, std::cos(angle)}};
    const double held = (3 + distance) / std::cos(angle) - 3;
    EXPECT_TRUE(guard.is_accessible(contact, 1.001 * held));
    EXPECT_FALSE(guard.is_accessible(contact, 0.999 * held));
    EXPECT_NEAR((guard.held_off(contact, 0.1).point - contact.point).norm(), held, 1e-4);
    EXPECT_EQ(guard.held_off(contact, 0.9 * held).point, contact.point);
    const CutterContact above{{20, 20, 0.1}, Vec3::UnitZ()};
    EXPECT_EQ(guard.held_off(above, 1).point, above.point);
}

StrategyOptions options_beside(const Part& other, double radius, double height)
{
    StrategyOptions options;
    options.scallop_height = height;
    options.inner_tolerance = tolerance;
    options.link.safe_height = 60;
    options.protected_part =
        std::make_shared<const ProtectedPart>(other, BallCutter{radius}, tolerance);
    return options;
}

void expect_clean(const StrategyPlan& plan)
{
    EXPECT_EQ(plan.verdict, Verdict::Clean);
    EXPECT_TRUE(plan.covering.uncovered.empty());
    ASSERT_TRUE(plan.of_protected);
    EXPECT_LE(plan.of_protected->max_gouge_mm, tolerance);
}

class PlanBesideAWall : public testing::TestWithParam<Strategy> {};

// A wall stands on the last 10 mm of a plane. The ball touches the plane up to its radius
// before the wall, whose length is 40 mm.
TEST_P(PlanBesideAWall, LeavesAStripAsWideAsTheRadius)
{
    const Part wall = test::box_mesh({50, -20, -5}, {70, 60, 40});
    for (const Part& part : {Part{std::vector<Surface>{test::plane(60, 40)}},
                             Part{test::flat_mesh(60, 40)}}) {
        const StrategyPlan plan = plan_by_strategy(GetParam(), part, BallCutter{5},
                                                   options_beside(wall, 5, 0.5));
        expect_clean(plan);
        EXPECT_NEAR(plan.covering.unreached_mm2, (10 + 5 + distance) * 40, 2);
        for (const PathPoint& point : plan.covering.path.points)
            EXPECT_TRUE(point.location.tip.x() <= 45 || point.location.tip.z() >= 40);
    }
}

INSTANTIATE_TEST_SUITE_P(Strategies, PlanBesideAWall,
                         testing::Values(Strategy::Planar, Strategy::IsoScallop,
                                         Strategy::Field));

class PlanAroundAPost : public testing::TestWithParam<double> {};

// Around a post of 8 by 6 mm the ball is kept off by w = R if the post is higher than its
// centre, and otherwise by the width at which it rolls over the edge. The corners are arcs.
// Half the scallop height, 0.25 mm, does not count.
TEST_P(PlanAroundAPost, LeavesARingAroundIt)
{
    const double height = GetParam();
    const Part post = test::box_mesh({26, 17, 0}, {34, 23, height});
    const std::vector<Surface> surfaces{test::plane(60, 40)};
    const StrategyPlan plan = plan_by_strategy(
        Strategy::IsoScallop, surfaces, BallCutter{5}, options_beside(post, 5, 0.5));
    expect_clean(plan);
    const double above = std::max(0.0, 5.25 - height);
    const double w = std::sqrt((5 + distance) * (5 + distance) - above * above);
    const double ring = 8 * 6 + 2 * (8 + 6) * w + std::numbers::pi * w * w;
    EXPECT_NEAR(plan.covering.unreached_mm2 / ring, 1, 0.01);
}

INSTANTIATE_TEST_SUITE_P(HighAndLow, PlanAroundAPost, testing::Values(12.0, 3.0, 1.0));

// A sphere about a centre, by meridians.
TriangleMesh sphere_mesh(const Vec3& centre, double radius)
{
    constexpr int meridians = 60;
    constexpr int parallels = 30;
    return test::grid_mesh(meridians, parallels, [&](int i, int j) -> Vec3 {
        const double longitude = 2 * std::numbers::pi * i / meridians;
        const double latitude =
            std::numbers::pi * (static_cast<double>(j) / parallels - 0.5);
        return centre + radius * Vec3{std::cos(latitude) * std::cos(longitude),
                                      std::cos(latitude) * std::sin(longitude),
                                      std::sin(latitude)};
    });
}

double distance_from_move(const Vec3& point, const Vec3& from, const Vec3& to)
{
    const Vec3 way = to - from;
    const double share =
        way.norm() > 0 ? std::clamp((point - from).dot(way) / way.squaredNorm(), 0.0, 1.0)
                       : 0;
    return (point - from - share * way).norm();
}

// Two balls do not overlap if their centres are as far apart as their radii. The corners of
// the mesh lie on the sphere, its facets up to 0.011 mm inside.
TEST(PlanBesideASphere, KeepsItsMovesOffTheSphere)
{
    const Vec3 middle{5, -3, 6};
    const Part sphere = sphere_mesh(middle, 4);
    const std::vector<Surface> surfaces{test::saddle(60, 25)};
    for (const Strategy strategy :
         {Strategy::Planar, Strategy::IsoScallop, Strategy::Field}) {
        const StrategyPlan plan = plan_by_strategy(strategy, surfaces, BallCutter{4},
                                                   options_beside(sphere, 4, 0.3));
        expect_clean(plan);
        EXPECT_GT(plan.covering.unreached_mm2, 0);
        const std::vector<PathPoint>& points = plan.covering.path.points;
        for (std::size_t k = 1; k < points.size(); ++k)
            EXPECT_GT(
                distance_from_move(middle, points[k - 1].location.tip + 4 * Vec3::UnitZ(),
                                   points[k].location.tip + 4 * Vec3::UnitZ()),
                4 + 4 - 0.0121);
    }
}

TEST(PlanBesideADistantPart, IsThatWithoutIt)
{
    const Part distant = test::box_mesh({500, 0, 0}, {510, 10, 10});
    const std::vector<Surface> surfaces{test::saddle(60, 20)};
    const StrategyOptions beside = options_beside(distant, 5, 0.5);
    StrategyOptions alone = beside;
    alone.protected_part = {};
    for (const Strategy strategy : every_strategy) {
        const StrategyPlan with =
            plan_by_strategy(strategy, surfaces, BallCutter{5}, beside);
        const StrategyPlan without =
            plan_by_strategy(strategy, surfaces, BallCutter{5}, alone);
        EXPECT_EQ(with.verdict, Verdict::Clean);
        EXPECT_EQ(with.covering.unreached_mm2, 0);
        EXPECT_EQ(with.of_protected->max_gouge_mm, 0);
        EXPECT_FALSE(without.of_protected);
        ASSERT_EQ(with.covering.path.points.size(), without.covering.path.points.size());
        for (std::size_t k = 0; k < with.covering.path.points.size(); ++k)
            EXPECT_EQ(with.covering.path.points[k].location.tip,
                      without.covering.path.points[k].location.tip);
    }
}

// A surface that continues the part smoothly: the ball at the border touches both, and is held
// off a little.
TEST(PlanBesideASmoothContinuation, CoversUpToTheBorder)
{
    const Part beyond =
        std::vector<Surface>{test::parallelogram({-20, 0, 0}, {0, 40, 0})};
    const std::vector<Surface> surfaces{test::plane(60, 40)};
    const StrategyPlan plan = plan_by_strategy(
        Strategy::IsoScallop, surfaces, BallCutter{5}, options_beside(beyond, 5, 0.1));
    expect_clean(plan);
    EXPECT_EQ(plan.covering.unreached_mm2, 0);
}

TEST(ProtectedPart, ThatBarsTheWholePartIsRefused)
{
    const Part roof = test::box_mesh({-20, -20, 20}, {90, 70, 30});
    const std::vector<Surface> surfaces{test::plane(60, 40)};
    for (const Strategy strategy : every_strategy)
        EXPECT_THROW(plan_by_strategy(strategy, surfaces, BallCutter{5},
                                      options_beside(roof, 5, 0.5)),
                     GeometryError);
    EXPECT_THROW(
        plan_by_best_strategy(surfaces, BallCutter{5}, options_beside(roof, 5, 0.5)),
        GeometryError);
}

// Passes along parameters cannot avoid the wall; the best plan is one of the others.
TEST(ProtectedPart, IsAvoidedByTheBestPlan)
{
    const Part wall = test::box_mesh({50, -20, -5}, {70, 60, 40});
    const std::vector<Surface> surfaces{test::plane(60, 40)};
    const StrategyOptions options = options_beside(wall, 5, 0.5);
    const BestPlan best = plan_by_best_strategy(surfaces, BallCutter{5}, options);
    expect_clean(best.plan);
    for (const TriedStrategy& one : best.tried)
        EXPECT_EQ(one.strategy == Strategy::IsoU || one.strategy == Strategy::IsoV,
                  !one.refusal.empty());
}

// The rapids of a path at a low safe height would enter a high wall.
TEST(ProtectedPart, RefusesRapidsThatEnterIt)
{
    ToolPath path;
    const auto add = [&](Move move, const Vec3& tip) {
        path.points.push_back({0, 0, move, 0, {tip, Vec3::UnitZ()}});
    };
    add(Move::Plunge, {0, 0, 0});
    add(Move::Retract, {0, 0, 10});
    add(Move::Rapid, {40, 0, 10});
    const Part wall = test::box_mesh({20, -20, 0}, {25, 20, 12});
    EXPECT_THROW((ProtectedPart{wall, BallCutter{2}, tolerance}).require_clear(path),
                 GeometryError);
    const Part low = test::box_mesh({20, -20, 0}, {25, 20, 9.9});
    EXPECT_NO_THROW((ProtectedPart{low, BallCutter{2}, tolerance}).require_clear(path));
}

// A groove of known depth in a plane that is protected.
TEST(ProtectedPart, MeasuresGouges)
{
    ToolPath path;
    const auto add = [&](Move move, const Vec3& tip) {
        path.points.push_back({0, 0, move, 0, {tip, Vec3::UnitZ()}});
    };
    add(Move::Plunge, {10, 20, -0.2});
    add(Move::Cut, {50, 20, -0.2});
    const Part plane = std::vector<Surface>{test::plane(60, 40)};
    const ProtectedPart guard{plane, BallCutter{5}, tolerance};
    const Deviation found = guard.deviation(path);
    EXPECT_LE(found.max_gouge_mm, 0.2 + 1e-9);
    EXPECT_GE(found.max_gouge_mm + found.gouge_bound_mm, 0.2 - 1e-9);
    EXPECT_EQ(guard.verdict(found, Verdict::Clean), Verdict::Gouged);
    EXPECT_EQ(guard.verdict(Deviation{}, Verdict::Uncut), Verdict::Uncut);
    EXPECT_THROW(guard.require_clear(path), GeometryError);
}

}  // namespace
}  // namespace endmill
