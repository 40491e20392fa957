// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/planar.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "endmill/core/parallel.h"
#include "endmill/planning/planner_options.h"
#include "endmill/strategy/strategy.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

StrategyOptions options_of(const std::vector<Surface>& surfaces)
{
    StrategyOptions options;
    options.scallop_height = 0.5;
    options.link.safe_height = default_safe_height(surfaces, Vec3::UnitZ());
    return options;
}

StrategyPlan planar(const std::vector<Surface>& surfaces, const StrategyOptions& options)
{
    return plan_by_strategy(Strategy::Planar, surfaces, BallCutter{7.5}, options);
}

// A ball of 7.5 mm leaves 0.5 mm between strips of 2 sqrt(0.5 (15 - 0.5)) = 5.385 mm.
// Strips across 200 mm: 38 of 120 mm; across 120 mm: 23 of 200 mm, which is longer.
TEST(PlanPlanar, FindsTheBetterSideOfARectangle)
{
    const std::vector<Surface> surfaces{test::plane(200, 120)};
    const StrategyPlan plan = planar(surfaces, options_of(surfaces));
    EXPECT_EQ(plan.verdict, Verdict::Clean);
    EXPECT_TRUE(plan.covering.uncovered.empty());
    EXPECT_EQ(plan.covering.passes, 38u);
    // a contact link joins the last two passes, which lie nearer to each other
    EXPECT_LE(plan.economy.cut.contact_mm,
              4560 + 5.385 * (38 - static_cast<double>(plan.covering.pieces)));
    EXPECT_GE(plan.covering.pieces, 37u);
    EXPECT_NEAR(plan.covering.direction->degrees(), 90, 1e-9);
    EXPECT_GE(plan.covering.compared.size(), 36u);
}

// A rectangle that is turned about the vertical costs the same: 9 passes of 30 mm, of which
// each end may stop 0.57 mm before the border.
TEST(PlanPlanar, DoesNotDependOnTheDirectionOfTheAxes)
{
    const double turn = 17 * std::numbers::pi / 180;
    test::Polynomial x = test::monomial(1, 0, std::cos(turn));
    x(0, 1) = -std::sin(turn);
    test::Polynomial y = test::monomial(1, 0, std::sin(turn));
    y(0, 1) = std::cos(turn);
    const std::vector<Surface> surfaces{
        test::polynomial_surface({x, y, test::Polynomial::Zero()}, {{0, 47}, {0, 30}})};
    const StrategyPlan plan = planar(surfaces, options_of(surfaces));
    EXPECT_EQ(plan.verdict, Verdict::Clean);
    EXPECT_LE(plan.economy.cut.contact_mm, 1.005 * 270);
    EXPECT_GE(plan.economy.cut.contact_mm, 270 - 2 * 9 * 0.57);
    EXPECT_NEAR(plan.covering.direction->degrees(), 107, 0.1);
}

// On z = 3x/4 strips are as wide along the slope as on a level plane: 250 mm need 47.
TEST(PlanPlanar, MeasuresStripsAlongTheSlope)
{
    const std::vector<Surface> surfaces{
        test::graph(test::monomial(1, 0, 0.75), {{0, 200}, {0, 120}})};
    StrategyOptions options = options_of(surfaces);
    options.direction = Angle::degrees(90);
    const StrategyPlan plan = planar(surfaces, options);
    EXPECT_EQ(plan.verdict, Verdict::Clean);
    EXPECT_EQ(plan.covering.passes, 47u);
    EXPECT_LE(plan.economy.cut.contact_mm,
              5640 + 5.385 * (47 - static_cast<double>(plan.covering.pieces)));
    EXPECT_TRUE(plan.covering.compared.empty());
}

// On a ridge z = -x^2 / 60, contacts travel least across it, and tips along it.
TEST(PlanPlanar, TurnsWithTheLengthThatCounts)
{
    const std::vector<Surface> surfaces{test::parabolic_cylinder(-1.0 / 60, 20, 60)};
    StrategyOptions options = options_of(surfaces);
    const StrategyPlan contact = planar(surfaces, options);
    options.distance = TravelKind::Tip;
    const StrategyPlan tip = planar(surfaces, options);
    const auto travel = [](const StrategyPlan& plan, TravelKind kind) {
        return counted_travel(plan.economy, kind, CountedMoves::CutsAndLinks);
    };
    EXPECT_LT(travel(contact, TravelKind::Contact), travel(tip, TravelKind::Contact));
    EXPECT_LT(travel(tip, TravelKind::Tip), travel(contact, TravelKind::Tip));
    EXPECT_NEAR(std::abs(contact.covering.direction->degrees() -
                         tip.covering.direction->degrees()),
                90, 1e-9);
    EXPECT_EQ(contact.verdict, Verdict::Clean);
    EXPECT_EQ(tip.verdict, Verdict::Clean);
}

TEST(PlanPlanar, DoesNotDependOnTheNumberOfThreads)
{
    const std::vector<Surface> surfaces{test::saddle(60, 25)};
    const StrategyOptions options = options_of(surfaces);
    set_thread_count(1);
    const StrategyPlan one = planar(surfaces, options);
    set_thread_count(3);
    const StrategyPlan three = planar(surfaces, options);
    ASSERT_EQ(one.covering.path.points.size(), three.covering.path.points.size());
    for (std::size_t k = 0; k < one.covering.path.points.size(); ++k)
        EXPECT_EQ(one.covering.path.points[k].location.tip,
                  three.covering.path.points[k].location.tip);
    ASSERT_EQ(one.covering.compared.size(), three.covering.compared.size());
    for (std::size_t k = 0; k < one.covering.compared.size(); ++k)
        EXPECT_EQ(one.covering.compared[k].cut_contact_mm,
                  three.covering.compared[k].cut_contact_mm);
}

TEST(ParameterDirections, AreThoseOfTheMiddleOfEachSurface)
{
    const Part part = std::vector<Surface>{test::plane(20, 10)};
    const std::vector<Angle> directions = parameter_directions(part);
    ASSERT_EQ(directions.size(), 2u);
    EXPECT_NEAR(directions[0].degrees(), 0, 1e-12);
    EXPECT_NEAR(directions[1].degrees(), 90, 1e-12);
}

// Along the longer side 40 mm of width need eight strips of at most 6 mm less the reserve of
// the height; the trials may need one more or less.
TEST(PlanarDirections, EstimateTheLengthOfThePasses)
{
    const Part part = std::vector<Surface>{test::plane(100, 40)};
    const BallCutter ball{5};
    const CoveredPart covered{part, ball, {0.01, 1}};
    StrategyOptions options;
    options.scallop_height = 1;
    const PlanarDirections found = planar_directions(covered, ball, options, {});
    ASSERT_TRUE(found.travel);
    EXPECT_NEAR(*found.travel, 700, 100);
    options.direction = Angle::degrees(30);
    EXPECT_FALSE(planar_directions(covered, ball, options, {}).travel);
}

}  // namespace
}  // namespace endmill
