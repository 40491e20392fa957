// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/points_bound.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "bound_surfaces.h"
#include "endmill/core/error.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

using test::SidedSurfaces;

BoundProblem with_stray(double stray)
{
    BoundProblem problem = test::usual_problem();
    problem.stray = stray;
    return problem;
}

PointsBound points_of(const SidedSurfaces& part, double stray)
{
    return points_bound(part.surfaces, part.sides, with_stray(stray));
}

// 120 mm / 5.44062496410109 mm = 22.06.
TEST(PointsBoundOf, APlaneIsItsWidthOverThatOfAStrip)
{
    const PointsBound found = points_of(test::dataset("plane"), 0.01);
    EXPECT_EQ(found.grade, BoundGrade::Closed);
    EXPECT_EQ(found.moves, std::ceil(120 / 5.44062496410109));
    EXPECT_EQ(found.moves, 23);
    EXPECT_EQ(found.points, 24);
}

TEST(PointsBoundOf, AStripIsOneMove)
{
    const PointsBound found = points_of(SidedSurfaces{{test::plane(80, 5)}}, 0.01);
    EXPECT_EQ(found.moves, 1);
    EXPECT_EQ(found.points, 1);
}

// Sides of 100 mm and 60 mm at 30 degrees to each other: the heights are 30 mm and 50 mm.
TEST(PointsBoundOf, AParallelogramIsItsLesserHeightOverThatOfAStrip)
{
    const double angle = std::numbers::pi / 6;
    const SidedSurfaces part{{test::parallelogram(
        {100, 0, 0}, {60 * std::cos(angle), 60 * std::sin(angle), 0})}};
    EXPECT_EQ(points_of(part, 0).moves, std::ceil(30 / (2 * std::sqrt(0.5 * 14.5))));
}

// A sphere of 50 mm, of which the surface file has 1854.59 mm^2.
TEST(PointsBoundOf, ASphereIsItsAreaOverThatOfAMove)
{
    const SidedSurfaces part = test::dataset("sphere");
    EXPECT_EQ(points_of(part, 0.01).grade, BoundGrade::Closed);
    EXPECT_EQ(points_of(part, 0.01).moves, 32);
    EXPECT_EQ(points_of(part, 0.01).points, 33);
    EXPECT_EQ(points_of(part, 0.5).moves, 16);
}

// Areas of random points of a sphere that the ball of a straight move reaches, against the
// greatest cover: the straight line of centres just keeps the tolerance in its middle.
TEST(PointsBoundOf, ASphereExceedsWhatAnyMoveCovers)
{
    const double rho = 50;
    const BoundProblem problem = with_stray(0.05);
    const double R = problem.cutter.radius();
    const SidedSurfaces part = test::dataset("sphere");
    const double area = 1854.590436;
    const double moves = points_of(part, 0.05).moves;
    std::mt19937_64 engine{3};
    std::normal_distribution<double> gauss;
    for (const double height : {-0.05, 0.0, 0.2, 0.4}) {
        const double distance =
            rho + R + height;  // of the line from the centre of the sphere
        const double outer = rho + R + problem.scallop_height;
        const double half = std::sqrt(outer * outer - distance * distance);
        int covered = 0;
        constexpr int samples = 200'000;
        for (int k = 0; k < samples; ++k) {
            const Vec3 place =
                Vec3{gauss(engine), gauss(engine), gauss(engine)}.normalized();
            const Vec3 raised = (rho + problem.scallop_height) * place;
            const double along = std::clamp(raised.x(), -half, half);
            covered += (raised - Vec3{along, 0, distance}).norm() <= R ? 1 : 0;
        }
        const double share = covered / static_cast<double>(samples);
        const double cover = 4 * std::numbers::pi * rho * rho * share;
        // rounding up hides less than one move
        EXPECT_LT(cover, area / (moves - 1)) << height;
    }
}

// The estimate by curvatures meets the closed form of a sphere. On a plane the longest move is
// the diagonal of the part, which no part has across its whole width.
TEST(PointsBoundOf, TheEstimateIsNearTheClosedForms)
{
    const SidedSurfaces sphere = test::dataset("sphere");
    for (const double stray : {0.01, 0.5}) {
        const PointsBound estimate =
            estimated_points_bound(sphere.surfaces, sphere.sides, with_stray(stray));
        EXPECT_EQ(estimate.grade, BoundGrade::Estimated);
        EXPECT_NEAR(estimate.moves, points_of(sphere, stray).moves, 1.01);
    }
    const SidedSurfaces plane = test::dataset("plane");
    const PointsBound estimate =
        estimated_points_bound(plane.surfaces, plane.sides, with_stray(0.01));
    EXPECT_LE(estimate.moves, 23);
    EXPECT_GE(estimate.moves, std::floor(200 * 120 / (5.45 * std::hypot(200, 120) + 24)));
}

TEST(PointsBoundOf, OtherSurfacesIsAnEstimate)
{
    for (const char* name : {"saddle", "torus", "cylinder"}) {
        const PointsBound found = points_of(test::dataset(name), 0.01);
        EXPECT_EQ(found.grade, BoundGrade::Estimated) << name;
        EXPECT_GT(found.moves, 1) << name;
        EXPECT_EQ(found.points, found.moves + 1) << name;
        // a larger tolerance allows longer moves
        EXPECT_LT(points_of(test::dataset(name), 0.2).moves, found.moves) << name;
    }
    EXPECT_THROW(points_bound({}, {}, with_stray(0)), DomainError);
}

// A steep plane: the flank covers more than the ball.
TEST(PointsBoundOf, ASteepPlaneIsAnEstimate)
{
    const double slope = 80 * std::numbers::pi / 180;
    const SidedSurfaces part{{test::parallelogram(
        {100, 0, 0}, {0, 60 * std::cos(slope), 60 * std::sin(slope)})}};
    EXPECT_EQ(points_of(part, 0.01).grade, BoundGrade::Estimated);
}

// Random straight moves across a plane, until everything is covered: never fewer points than
// the bound, whatever the moves.
TEST(PointsBoundOf, NoRandomCoveringPathOfAPlaneHasFewerPoints)
{
    constexpr double size_x = 40;
    constexpr double size_y = 24;
    const BoundProblem problem = with_stray(0);
    const double half_width = plane_half_width(problem);
    const PointsBound bound = points_of(SidedSurfaces{{test::plane(size_x, size_y)}}, 0);
    ASSERT_EQ(bound.grade, BoundGrade::Closed);
    struct Segment {
        Eigen::Vector2d from;
        Eigen::Vector2d to;
        bool covers(const Eigen::Vector2d& point, double reach) const
        {
            const Eigen::Vector2d way = to - from;
            const double share =
                std::clamp((point - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
            return (point - from - share * way).norm() <= reach;
        }
    };
    std::mt19937_64 engine{11};
    std::uniform_real_distribution<double> uniform{0, 1};
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<Eigen::Vector2d> open;
        for (int i = 0; i <= 40; ++i)
            for (int j = 0; j <= 24; ++j)
                open.emplace_back(size_x * i / 40, size_y * j / 24);
        double moves = 0;
        // moves through a place that is not covered, at an angle, over the whole part
        for (; !open.empty(); ++moves) {
            const Eigen::Vector2d through = open[engine() % open.size()];
            const double angle = trial % 4 == 0 ? 0.02 * uniform(engine)
                                                : std::numbers::pi * uniform(engine);
            const Eigen::Vector2d way =
                60 * Eigen::Vector2d{std::cos(angle), std::sin(angle)};
            const Segment move{through - way, through + way};
            std::erase_if(open, [&](const Eigen::Vector2d& point) {
                return move.covers(point, half_width);
            });
        }
        EXPECT_GE(moves + 1, bound.points);
        EXPECT_GE(moves, bound.moves);
    }
    // parallel moves at the width of a strip need just as many
    EXPECT_EQ(bound.moves, std::ceil(size_y / (2 * half_width)));
}

}  // namespace
}  // namespace endmill
