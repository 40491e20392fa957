// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/planner_options.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/planning/iso_parametric.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

// A trough along y with the radius of curvature `radius` at its bottom: smaller balls
// fit.
Surface trough(double radius)
{
    return test::parabolic_cylinder(1 / radius, 2 * radius, 3 * radius);
}

// Plans passes along the trough with the default tolerance.
void plan_along(const Surface& surface, double diameter)
{
    const BallCutter ball{diameter / 2};
    const double tolerance = default_tolerance(ball);
    plan_iso_parametric(surface, ball,
                        {.direction = Parameter::V,
                         .chord_tolerance = tolerance,
                         .scallop_height = tolerance});
}

TEST(DefaultDiameter, IsTheLargestThatTheTightestPlaceAdmits)
{
    for (std::size_t k = 0; k < stock_diameters.size(); ++k) {
        const double diameter = stock_diameters[k];
        const auto in_trough = [](double radius) {
            return default_diameter(largest_cutter(trough(radius), 1));
        };
        EXPECT_EQ(in_trough(1.01 * diameter / 2), diameter);
        if (k + 1 < stock_diameters.size())
            EXPECT_EQ(in_trough(0.99 * diameter / 2), stock_diameters[k + 1]);
        else
            EXPECT_FALSE(in_trough(0.99 * diameter / 2));
    }
}

TEST(DefaultDiameter, IsTheLargestThatCanBePlannedWith)
{
    for (std::size_t k = 1; k < stock_diameters.size(); ++k) {
        const Surface surface = trough(1.01 * stock_diameters[k] / 2);
        const auto diameter = default_diameter(largest_cutter(surface, 1));
        ASSERT_TRUE(diameter);
        EXPECT_NO_THROW(plan_along(surface, *diameter));
        EXPECT_THROW(plan_along(surface, stock_diameters[k - 1]), GeometryError);
    }
}

TEST(DefaultDiameter, IsTheLargestOfAllWithoutConcavity)
{
    const auto limit = largest_cutter(test::plane(60, 30), 1);
    EXPECT_FALSE(limit);
    EXPECT_EQ(default_diameter(limit), 20);
}

TEST(Fits, IsFalseAtTheLimitItself)
{
    const CutterLimit limit{10, 0, {0, 0}, Vec3::Zero()};
    EXPECT_TRUE(fits(BallCutter{std::nextafter(10, 0)}, limit));
    EXPECT_FALSE(fits(BallCutter{10}, limit));
    EXPECT_TRUE(fits(BallCutter{1e6}, std::nullopt));
}

TEST(FittingDiameter, IsTheRequestedOneIfItsBallFits)
{
    const CutterLimit limit{10, 0, {0, 0}, Vec3::Zero()};
    EXPECT_EQ(fitting_diameter(19.9, limit), 19.9);
    EXPECT_EQ(fitting_diameter(20, limit), std::nullopt);
    EXPECT_EQ(fitting_diameter(1e6, std::nullopt), 1e6);
}

TEST(FittingDiameter, WithoutARequestIsTheDefault)
{
    for (const double radius : {0.4, 0.6, 3.1, 100.0}) {
        const CutterLimit limit{radius, 0, {0, 0}, Vec3::Zero()};
        EXPECT_EQ(fitting_diameter(std::nullopt, limit), default_diameter(limit));
    }
}

TEST(VerifiedOptions, HaveTheDefaultsOfAVerifiedPlan)
{
    const VerifiedOptions options;
    const PlanTolerances defaults = plan_tolerances({}, Planner::Verified, BallCutter{5});
    EXPECT_EQ(options.tolerances.inner, defaults.motion.inner);
    EXPECT_EQ(options.tolerances.outer, defaults.motion.outer);
    EXPECT_EQ(options.scallop_height, defaults.scallop_height);
}

TEST(PlanTolerances, AreTheRequestedOnesWhereThereAreAny)
{
    for (const Planner planner : {Planner::Paper, Planner::Verified}) {
        const PlanTolerances all =
            plan_tolerances({0.1, 0.2, 0.3, 0.4}, planner, BallCutter{5});
        EXPECT_EQ(all.chord, 0.1);
        EXPECT_EQ(all.scallop_height, 0.2);
        EXPECT_EQ(all.motion.inner, 0.3);
        EXPECT_EQ(all.motion.outer, 0.4);
        const PlanTolerances inner =
            plan_tolerances({.chord = 0.1, .inner = 0.3}, planner, BallCutter{5});
        EXPECT_EQ(inner.scallop_height, 0.1);
        EXPECT_EQ(inner.motion.inner, 0.3);
        EXPECT_EQ(inner.motion.outer, 0.1);
    }
}

TEST(PlanTolerances, DependOnTheBallForThePaperOnly)
{
    for (const double radius : {1.0, 7.5, 20.0}) {
        const BallCutter ball{radius};
        const PlanTolerances paper = plan_tolerances({}, Planner::Paper, ball);
        EXPECT_EQ(paper.chord, 2 * radius / 30);
        EXPECT_EQ(paper.motion.inner, paper.chord);
        EXPECT_EQ(plan_tolerances({}, Planner::Verified, ball).chord, 0.01);
    }
}

TEST(DefaultTolerance, IsThatOfThePapersFigureForItsBallAndGrowsWithTheBall)
{
    EXPECT_EQ(default_tolerance(BallCutter{7.5}), 0.5);
    EXPECT_EQ(default_tolerance(BallCutter{15}), 1);
}

TEST(DefaultSafeHeight, Is5AboveTheHighestPoint)
{
    const Surface tilted = test::parallelogram({40, 0, 30}, {0, 20, 0});
    EXPECT_NEAR(default_safe_height(std::vector{tilted}, Vec3::UnitZ()), 30 + 5, 1e-7);
    EXPECT_NEAR(default_safe_height(std::vector{tilted}, Vec3{0.6, 0, 0.8}), 24 + 24 + 5,
                1e-7);
    const Surface hill = test::graph(
        test::monomial(0, 0, 7) + test::monomial(2, 0, -0.1) + test::monomial(0, 2, -0.1),
        {{-10, 20}, {-15, 10}}, {2, 2});
    EXPECT_NEAR(default_safe_height(std::vector{hill}, Vec3::UnitZ()), 7 + 5, 1e-7);
}

}  // namespace
}  // namespace endmill
