// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/closed_bound.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "bound_surfaces.h"
#include "endmill/core/error.h"
#include "random.h"

namespace endmill {
namespace {

using std::numbers::pi;
using test::relative_error;

constexpr double closed_accuracy = 1e-9;

BoundProblem tips()
{
    BoundProblem problem = test::usual_problem();
    problem.length = BoundedLength::Tip;
    return problem;
}

// The set that the tool covers on a plane of this slope, by sampling of points at the
// distance h above it: the widest extent in any direction, and the area.
struct SampledDisc {
    double width;
    double area;
};

SampledDisc sampled_on_plane(const BoundProblem& problem, double slope)
{
    const Vec3 normal{std::sin(slope), 0, std::cos(slope)};
    const Vec3 uphill{-std::cos(slope), 0, std::sin(slope)};
    const double R = problem.cutter.radius();
    constexpr int directions = 1440;
    std::vector<Eigen::Vector2d> border;
    double area = 0;
    for (int k = 0; k < directions; ++k) {
        const double angle = 2 * pi * k / directions;
        const Vec3 along = std::cos(angle) * uphill + std::sin(angle) * Vec3::UnitY();
        double inside = 0;
        double outside = 100;
        while (outside - inside > 1e-12) {
            const double r = (inside + outside) / 2;
            Vec3 away = (problem.scallop_height - R) * normal + r * along;
            away.z() = std::min(away.z(), 0.0);
            (away.norm() <= R + problem.stray ? inside : outside) = r;
        }
        border.emplace_back(inside * std::cos(angle), inside * std::sin(angle));
        area += inside * inside * pi / directions;
    }
    double width = 0;
    for (int k = 0; k < directions; k += 4) {
        const Eigen::Vector2d across{std::cos(pi * k / directions),
                                     std::sin(pi * k / directions)};
        double low = 0;
        double high = 0;
        for (const Eigen::Vector2d& point : border) {
            low = std::min(low, across.dot(point));
            high = std::max(high, across.dot(point));
        }
        width = std::max(width, high - low);
    }
    return {width, area};
}

TEST(PlaneDensity, OnALevelPlaneIsOneOverTheWidthOfTheDisc)
{
    const ClosedDensity plane = plane_density(test::usual_problem(), Angle::degrees(0));
    EXPECT_LT(relative_error(200 * 120 * plane.density_per_mm, 4456.68811624925),
              closed_accuracy);
    EXPECT_LT(relative_error(plane.disc_mm, 4.22949854911602), closed_accuracy);
}

TEST(PlaneDensity, FollowsTheFlankOnSteepPlanes)
{
    const BoundProblem problem = test::usual_problem();
    const double level = plane_density(problem, Angle::degrees(0)).density_per_mm;
    const auto rate = [&](double degrees) {
        return level / plane_density(problem, Angle::degrees(degrees)).density_per_mm;
    };
    EXPECT_DOUBLE_EQ(rate(60), 1);
    EXPECT_LT(relative_error(rate(75), 1.02986663136281), closed_accuracy);
    EXPECT_LT(relative_error(rate(80), 1.14841207489643), closed_accuracy);
    EXPECT_LT(relative_error(rate(85), 1.62206096557027), closed_accuracy);
}

TEST(PlaneDensity, OfTheBallAloneDoesNotDependOnTheSlope)
{
    BoundProblem problem = test::usual_problem();
    problem.tool = CoveringTool::Ball;
    for (const double degrees : {0.0, 60.0, 85.0, 90.0, 120.0}) {
        const ClosedDensity plane = plane_density(problem, Angle::degrees(degrees));
        EXPECT_DOUBLE_EQ(plane.density_per_mm, 1 / (2 * plane_half_width(problem)));
    }
}

TEST(PlaneDensity, AgreesWithASampledDiscOnAnySlope)
{
    for (const double stray : {0.0, 0.3})
        for (const double degrees : {0.0, 40.0, 68.0, 72.0, 80.0, 86.0}) {
            BoundProblem problem = test::usual_problem();
            problem.stray = stray;
            const SampledDisc disc = sampled_on_plane(problem, degrees * pi / 180);
            const ClosedDensity plane = plane_density(problem, Angle::degrees(degrees));
            EXPECT_LT(relative_error(1 / plane.density_per_mm, disc.width), 1e-4);
            EXPECT_LT(relative_error(plane.disc_mm / plane.density_per_mm, disc.area),
                      1e-4)
                << degrees;
        }
}

TEST(PlaneDensity, RefusesAVerticalPlaneWithTheFlank)
{
    EXPECT_THROW(plane_density(test::usual_problem(), Angle::degrees(90.001)),
                 DomainError);
}

TEST(SphereDensity, MatchesTheVectorsOfAConvexAndAConcaveSphere)
{
    constexpr double area = 1854.590436;
    const ClosedDensity contact = *sphere_density(test::usual_problem(), 1 / 25.0);
    EXPECT_LT(relative_error(area * contact.density_per_mm, 397.005210062024), 1e-9);
    EXPECT_LT(relative_error(contact.disc_mm, 3.67699081990477), closed_accuracy);
    const ClosedDensity tip = *sphere_density(tips(), 1 / 25.0);
    EXPECT_LT(relative_error(area * tip.density_per_mm, 516.106773080631), 1e-9);
    EXPECT_LT(relative_error(tip.disc_mm, 4.78008806587620), closed_accuracy);
    const ClosedDensity concave = *sphere_density(test::usual_problem(), -1 / 50.0);
    EXPECT_LT(relative_error(1 / concave.density_per_mm, 5.86792796099857),
              closed_accuracy);
    EXPECT_LT(relative_error(concave.disc_mm, 4.61263388935137), closed_accuracy);
}

TEST(SphereDensity, TendsToThatOfAPlane)
{
    for (const double sign : {1.0, -1.0}) {
        const ClosedDensity sphere = *sphere_density(test::usual_problem(), sign * 1e-9);
        const ClosedDensity plane =
            plane_density(test::usual_problem(), Angle::degrees(0));
        EXPECT_LT(relative_error(sphere.density_per_mm, plane.density_per_mm), 1e-7);
        EXPECT_LT(relative_error(sphere.disc_mm, plane.disc_mm), 1e-7);
    }
}

TEST(SphereDensity, OfABallThatDoesNotFitIsMissing)
{
    EXPECT_FALSE(sphere_density(test::usual_problem(), -1 / 7.5));
    EXPECT_FALSE(sphere_density(test::usual_problem(), -1 / 7.6));
    EXPECT_THROW(sphere_density(test::usual_problem(), 0), DomainError);
}

TEST(CylinderDensity, MatchesTheVectorsOfAConvexCylinder)
{
    const double area = 20 * 60 * 4 * std::atan(0.75);
    const ClosedDensity contact = *cylinder_density(test::usual_problem(), 1 / 20.0);
    EXPECT_LT(relative_error(area * contact.density_per_mm, 573.576748831868),
              closed_accuracy);
    EXPECT_LT(relative_error(contact.disc_mm, 3.56410352635941), closed_accuracy);
    const ClosedDensity tip = *cylinder_density(tips(), 1 / 20.0);
    EXPECT_LT(relative_error(1 / tip.density_per_mm, 4.53856654049078), closed_accuracy);
    EXPECT_LT(relative_error(area * tip.density_per_mm, 680.568477831768),
              closed_accuracy);
    EXPECT_LT(relative_error(tip.disc_mm, 4.22893103095481), closed_accuracy);
}

// The largest of the strips that a rigid motion of the disc over the developed cylinder
// sweeps per mm of the length, over all directions.
TEST(CylinderDensity, IsOneOverTheWidestStripOfAllDirections)
{
    for (const BoundProblem& problem : {test::usual_problem(), tips()})
        for (const double curvature : {1 / 20.0, 1 / 5.0, -1 / 20.0, -1 / 9.0}) {
            const double rho = 1 / curvature;
            const double y = rho + 0.5;
            const double c = rho + 7.5;
            const double tip_ratio = problem.length == BoundedLength::Tip ? rho / c : 1;
            double widest = 0;
            for (double s = 0; s < 2 * std::abs(rho); s += 1e-4) {
                const double z2 =
                    7.5 * 7.5 - y * y - c * c + 2 * y * c * std::cos(s / rho);
                if (z2 < 0)
                    break;
                widest =
                    std::max(widest, 2 * std::sqrt(s * s + tip_ratio * tip_ratio * z2));
            }
            EXPECT_LT(
                relative_error(1 / cylinder_density(problem, curvature)->density_per_mm,
                               widest),
                1e-4)
                << curvature;
        }
}

TEST(SteepestWithoutFlank, MatchesTheVectors)
{
    EXPECT_NEAR(steepest_without_flank(test::usual_problem(), 1 / 25.0)->degrees(), 71.48,
                0.005);
    EXPECT_NEAR(steepest_without_flank(test::usual_problem(), 1 / 20.0)->degrees(), 71.97,
                0.005);
    // On a plane asin(1 - h / R).
    EXPECT_NEAR(steepest_without_flank(test::usual_problem(), 1e-7)->degrees(), 68.96,
                0.005);
}

TEST(SteepestWithoutFlank, IsWhereTheHighestCoveredPointIsLevelWithTheCentre)
{
    for (const double rho : {25.0, 12.0, -50.0, -12.0}) {
        const double theta =
            steepest_without_flank(test::usual_problem(), 1 / rho)->radians();
        // A point of the raised circle at the height of the centre and R from it.
        const double centre_x = (rho + 7.5) * std::sin(theta);
        const double height = (rho + 7.5) * std::cos(theta);
        const double across = std::sqrt(std::pow(rho + 0.5, 2) - height * height);
        EXPECT_NEAR(std::abs(centre_x - (rho > 0 ? across : -across)), 7.5, 1e-9) << rho;
    }
}

TEST(ClosedDensityOf, AShapeSteeperThanTheBallDecidesIsMissing)
{
    const auto shape = [](double degrees) {
        return SimpleShape{ShapeKind::Sphere, 1 / 25.0, 100, Angle::degrees(degrees)};
    };
    BoundProblem problem = test::usual_problem();
    EXPECT_TRUE(closed_density(problem, shape(71.4)));
    EXPECT_FALSE(closed_density(problem, shape(71.6)));
    problem.tool = CoveringTool::Ball;
    EXPECT_TRUE(closed_density(problem, shape(100)));
}

TEST(ClosedDensities, FallAsThePathMayStray)
{
    for (const BoundProblem& ideal : {test::usual_problem(), tips()}) {
        BoundProblem straying = ideal;
        straying.stray = 0.05;
        EXPECT_LT(sphere_density(straying, 0.04)->density_per_mm,
                  sphere_density(ideal, 0.04)->density_per_mm);
        EXPECT_LT(cylinder_density(straying, 0.04)->density_per_mm,
                  cylinder_density(ideal, 0.04)->density_per_mm);
        EXPECT_LT(plane_density(straying, Angle::degrees(80)).density_per_mm,
                  plane_density(ideal, Angle::degrees(80)).density_per_mm);
    }
}

}  // namespace
}  // namespace endmill
