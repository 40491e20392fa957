// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/path_bound.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "bound_surfaces.h"
#include "endmill/bound/detail/closed_bound.h"
#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/surface/extent.h"
#include "random.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

using test::relative_error;
using test::SidedSurfaces;

// A coarser estimate than the default, on small parts.
EstimateOptions quick(const BoundProblem& problem)
{
    EstimateOptions options;
    options.node_spacing = 1.4 * plane_half_width(problem);
    options.random_places = 2000;
    return options;
}

PathBound bound_of(const SidedSurfaces& part, const BoundProblem& problem)
{
    return path_bound(part.surfaces, part.sides, problem, quick(problem));
}

PathBound estimate_of(const SidedSurfaces& part, const BoundProblem& problem)
{
    return estimated_bound(part.surfaces, part.sides, problem, quick(problem));
}

BoundProblem with_length(BoundedLength length)
{
    BoundProblem problem = test::usual_problem();
    problem.length = length;
    return problem;
}

// An estimate may be up to 1 % below the closed value, and 0.1 % above it by quadrature.
void expect_estimate(const PathBound& estimate, double density, double disc)
{
    EXPECT_EQ(estimate.grade, BoundGrade::Estimated);
    EXPECT_GT(estimate.density_mm, 0.99 * density);
    EXPECT_LT(estimate.density_mm, 1.001 * density);
    EXPECT_NEAR(estimate.disc_mm, disc, 0.01 * disc);
}

TEST(PathBoundOf, APlaneASphereAndTiltedPlanesIsClosed)
{
    const PathBound plane = bound_of(test::dataset("plane"), test::usual_problem());
    EXPECT_EQ(plane.grade, BoundGrade::Closed);
    EXPECT_LT(relative_error(plane.density_mm, 4456.68811624925), 1e-9);
    EXPECT_LT(relative_error(*plane.bound_mm, 4452.45861770013), 1e-9);
    const PathBound tilted =
        bound_of(test::dataset("tilted-plane"), test::usual_problem());
    EXPECT_LT(relative_error(*tilted.bound_mm, 5566.63064676244), 1e-9);
    const SidedSurfaces turned{
        {test::parallelogram({200 * std::cos(0.3), 200 * std::sin(0.3), 0},
                             {-120 * std::sin(0.3), 120 * std::cos(0.3), 0}, {3, 2})}};
    EXPECT_LT(relative_error(*bound_of(turned, test::usual_problem()).bound_mm,
                             4452.45861770013),
              1e-9);
    const PathBound sphere = bound_of(test::dataset("sphere"), test::usual_problem());
    EXPECT_EQ(sphere.grade, BoundGrade::Closed);
    EXPECT_LT(relative_error(sphere.density_mm, 397.005210062024), 1e-9);
    EXPECT_LT(relative_error(sphere.disc_mm, 3.67699081990477), 1e-9);
    const PathBound tips =
        bound_of(test::dataset("sphere"), with_length(BoundedLength::Tip));
    EXPECT_LT(relative_error(tips.density_mm, 516.106773080631), 1e-9);
}

// The cylinder is steeper than its closed form holds for with the flank.
TEST(PathBoundOf, ASteepCylinderIsClosedForTheBallAlone)
{
    const SidedSurfaces cylinder = test::dataset("cylinder");
    EXPECT_EQ(bound_of(cylinder, test::usual_problem()).grade, BoundGrade::Estimated);
    BoundProblem ball = test::usual_problem();
    ball.tool = CoveringTool::Ball;
    const PathBound closed = bound_of(cylinder, ball);
    EXPECT_EQ(closed.grade, BoundGrade::Closed);
    EXPECT_LT(relative_error(closed.density_mm, 573.576748831868), 1e-9);
    EXPECT_LT(relative_error(closed.disc_mm, 3.56410352635941), 1e-9);
}

class EstimatedBound : public testing::TestWithParam<BoundedLength> {};

TEST_P(EstimatedBound, AgreesWithTheClosedFormOfThePlaneSphereAndCylinder)
{
    const BoundProblem problem = with_length(GetParam());
    for (const char* const name : {"plane", "sphere", "cylinder"}) {
        const SidedSurfaces part = test::dataset(name);
        const auto shape = simple_shape(part.surfaces[0], part.sides[0]);
        BoundProblem ball = problem;
        ball.tool = CoveringTool::Ball;
        const ClosedDensity closed = *closed_density(ball, *shape);
        expect_estimate(estimate_of(part, problem), shape->area * closed.density_per_mm,
                        closed.disc_mm);
    }
}

TEST_P(EstimatedBound, AgreesWithTheClosedFormOfConcaveShapes)
{
    BoundProblem problem = with_length(GetParam());
    problem.tool = CoveringTool::Ball;
    for (const char* const name : {"sphere", "cylinder"}) {
        SidedSurfaces part = test::dataset(name);
        part.sides[0] *= -1;
        const PathBound closed = bound_of(part, problem);
        EXPECT_EQ(closed.grade, BoundGrade::Closed);
        expect_estimate(estimate_of(part, problem), closed.density_mm, closed.disc_mm);
    }
}

TEST_P(EstimatedBound, AgreesWithTheClosedFormWhenPathsStray)
{
    BoundProblem problem = with_length(GetParam());
    problem.stray = 0.05;
    problem.tool = CoveringTool::Ball;
    for (const char* const name : {"plane", "sphere", "cylinder"}) {
        const PathBound closed = bound_of(test::dataset(name), problem);
        expect_estimate(estimate_of(test::dataset(name), problem), closed.density_mm,
                        closed.disc_mm);
    }
}

INSTANTIATE_TEST_SUITE_P(OfBothLengths, EstimatedBound,
                         testing::Values(BoundedLength::Contact, BoundedLength::Tip));

TEST(EstimatedBoundOf, ASteepPlaneCountsTheFlank)
{
    const double slope = 78 * std::numbers::pi / 180;
    const SidedSurfaces part{{test::parallelogram(
        {80, 0, 0}, {0, 80 * std::cos(slope), 80 * std::sin(slope)}, {2, 2})}};
    const PathBound closed = bound_of(part, test::usual_problem());
    EXPECT_EQ(closed.grade, BoundGrade::Closed);
    const PathBound estimate = estimate_of(part, test::usual_problem());
    EXPECT_LT(estimate.density_mm, 1.001 * closed.density_mm);
    EXPECT_GT(estimate.density_mm, 0.985 * closed.density_mm);
}

TEST(EstimatedBoundOf, TheSaddleIsThatOfAnIndependentProgram)
{
    const SidedSurfaces saddle = test::dataset("saddle");
    EXPECT_NEAR(bound_of(saddle, test::usual_problem()).density_mm, 2107.5,
                0.005 * 2107.5);
    EXPECT_NEAR(bound_of(saddle, with_length(BoundedLength::Tip)).density_mm, 2109.1,
                0.005 * 2109.1);
}

// The value of another implementation, which tested the condition a quarter of a spacing
// apart. experiments/economy/bound compares nodes 2 mm apart too.
TEST(EstimatedBoundOf, TheNetIsThatOfAnIndependentProgram)
{
    const SidedSurfaces net = test::dataset("net_rot24_7D");
    BoundProblem ball = test::usual_problem();
    ball.tool = CoveringTool::Ball;
    EstimateOptions options;
    options.node_spacing = 4;
    options.random_places = 2000;
    const double density = path_bound(net.surfaces, net.sides, ball, options).density_mm;
    EXPECT_NEAR(density, 10276, 0.005 * 10276);
}

TEST(EstimatedBoundOf, TheFlankAndStrayAreLower)
{
    const SidedSurfaces steep = test::dataset("parabolic-cylinder");
    BoundProblem problem = test::usual_problem();
    const double with_flank = bound_of(steep, problem).density_mm;
    problem.tool = CoveringTool::Ball;
    const double of_ball = bound_of(steep, problem).density_mm;
    EXPECT_LT(with_flank, 1.0005 * of_ball);
    problem.stray = 0.05;
    EXPECT_LT(bound_of(steep, problem).density_mm, of_ball);
}

TEST(EstimatedBoundOf, MorePiecesIsLowerAndFinallyNothing)
{
    const SidedSurfaces part{{test::saddle(64, 15)}};
    BoundProblem problem = test::usual_problem();
    double last = std::numeric_limits<double>::infinity();
    for (const int pieces : {1, 3, 10}) {
        problem.most_pieces = pieces;
        const PathBound bound = bound_of(part, problem);
        ASSERT_TRUE(bound.bound_mm);
        EXPECT_EQ(*bound.bound_mm, bound.density_mm - pieces * bound.disc_mm);
        EXPECT_LT(*bound.bound_mm, last);
        last = *bound.bound_mm;
    }
    // Plunges alone cover the part; a bound above 0 would refute itself.
    problem.most_pieces = 100;
    EXPECT_FALSE(bound_of(part, problem).bound_mm);
}

TEST(EstimatedBoundOf, APartSmallerThanADiscIsNothing)
{
    EXPECT_FALSE(
        bound_of(SidedSurfaces{{test::saddle(64, 1)}}, test::usual_problem()).bound_mm);
    EXPECT_FALSE(
        bound_of(SidedSurfaces{{test::plane(1, 1)}}, test::usual_problem()).bound_mm);
}

// On a small part the default has nodes twice as close, which gives a larger bound.
TEST(EstimatedBoundOf, ASmallPartHasCloserNodesByDefault)
{
    const SidedSurfaces part = test::dataset("sphere");
    const BoundProblem problem = test::usual_problem();
    const PathBound closer = estimated_bound(part.surfaces, part.sides, problem);
    EXPECT_NEAR(closer.node_spacing_mm, 0.7 * plane_half_width(problem), 1e-12);
    EXPECT_EQ(closer.test_places, 20000U);
    expect_estimate(closer, 397.005210062024, 3.67699081990477);
}

// The integral of the density by flat cells. Cells of 3 mm of the saddle differ from the flat
// ones by less than a thousandth.
TEST(EstimatedBoundOf, TheDensityOfTheCellsAddsUpToTheIntegral)
{
    const SidedSurfaces part{{test::saddle(64, 15)}};
    const PathBound bound = bound_of(part, test::usual_problem());
    double sum = 0;
    for (const auto& [points, mean] : bound.density)
        sum += mean * (points[2] - points[0]).cross(points[3] - points[1]).norm() / 2;
    EXPECT_NEAR(sum, bound.density_mm, 1e-3 * bound.density_mm);
}

TEST(EstimatedBoundOf, AScaledPartScales)
{
    BoundProblem large{BallCutter{15}, 1, 0.02};
    BoundProblem small{BallCutter{7.5}, 0.5, 0.01};
    for (const BoundedLength length : {BoundedLength::Contact, BoundedLength::Tip}) {
        large.length = length;
        small.length = length;
        const PathBound of_large =
            bound_of(SidedSurfaces{{test::saddle(128, 80)}}, large);
        const PathBound of_small = bound_of(SidedSurfaces{{test::saddle(64, 40)}}, small);
        EXPECT_LT(relative_error(of_large.density_mm, 2 * of_small.density_mm), 1e-3);
        EXPECT_LT(relative_error(of_large.disc_mm, 2 * of_small.disc_mm), 1e-3);
    }
}

// A part in one surface and the same part cut into two.
TEST(EstimatedBoundOf, ACutPartIsThatOfTheWhole)
{
    const auto piece = [](Interval x) {
        return test::graph(
            test::monomial(2, 0, 1 / 128.0) + test::monomial(0, 2, -1 / 128.0),
            {x, {-20, 20}});
    };
    const PathBound whole =
        bound_of(SidedSurfaces{{piece({-30, 30})}}, test::usual_problem());
    const PathBound cut =
        bound_of(SidedSurfaces{{piece({-30, 4}), piece({4, 30})}}, test::usual_problem());
    EXPECT_LT(relative_error(cut.density_mm, whole.density_mm), 0.006);
    EXPECT_LT(relative_error(cut.disc_mm, whole.disc_mm), 0.01);
}

TEST(EstimatedBoundOf, AnyNumberOfThreadsHasTheSameBits)
{
    const SidedSurfaces part = test::dataset("wavy");
    set_thread_count(1);
    const PathBound one = bound_of(part, test::usual_problem());
    for (const int threads : {2, 3, 8}) {
        set_thread_count(threads);
        const PathBound more = bound_of(part, test::usual_problem());
        EXPECT_EQ(one.density_mm, more.density_mm);
        EXPECT_EQ(one.disc_mm, more.disc_mm);
        EXPECT_EQ(one.greatest_inflow, more.greatest_inflow);
        EXPECT_EQ(one.places, more.places);
    }
}

// The certificate against the closed form, and against the estimate.
TEST(CertifiedBoundOf, APlaneIsAtMostTheClosedFormAndCloseToIt)
{
    for (const BoundedLength length : {BoundedLength::Contact, BoundedLength::Tip}) {
        const BoundProblem problem = with_length(length);
        const SidedSurfaces part{{test::plane(30, 30)}};
        const PathBound closed = bound_of(part, problem);
        ASSERT_EQ(closed.grade, BoundGrade::Closed);
        const PathBound estimate = estimate_of(part, problem);
        const PathBound proved =
            certified_bound(part.surfaces, part.sides, problem, quick(problem));
        EXPECT_EQ(proved.grade, BoundGrade::Certified);
        EXPECT_LE(proved.density_mm, estimate.density_mm);
        EXPECT_GE(proved.density_mm, 0.95 * closed.density_mm);
        EXPECT_GE(proved.disc_mm, estimate.disc_mm);
    }
}

TEST(CertifiedBoundOf, TheSaddleIsBetween95And100PercentOfTheEstimate)
{
    const SidedSurfaces part = test::dataset("saddle");
    const BoundProblem problem = test::usual_problem();
    const PathBound estimate = estimate_of(part, problem);
    EstimateOptions options = quick(problem);
    options.grade = BoundGrade::Certified;
    const PathBound proved = path_bound(part.surfaces, part.sides, problem, options);
    EXPECT_EQ(proved.grade, BoundGrade::Certified);
    EXPECT_GT(proved.boxes, 0U);
    EXPECT_LE(proved.density_mm, estimate.density_mm);
    EXPECT_GE(proved.density_mm, 0.95 * estimate.density_mm);
}

TEST(PathBoundOf, InvalidInputIsRefused)
{
    const SidedSurfaces part = test::dataset("plane");
    const BoundProblem problem = test::usual_problem();
    EXPECT_THROW(path_bound({}, {}, problem), DomainError);
    EXPECT_THROW(path_bound(part.surfaces, {}, problem), DomainError);
    EXPECT_THROW(path_bound(part.surfaces, part.sides, {BallCutter{1}, 2}), DomainError);
    EstimateOptions options;
    options.node_spacing = 0;
    EXPECT_THROW(estimated_bound(part.surfaces, part.sides, problem, options),
                 DomainError);
    options = {};
    options.random_places = 10;
    EXPECT_THROW(estimated_bound(part.surfaces, part.sides, problem, options),
                 DomainError);
}

TEST(PathBoundOf, ACreasedPartIsRefused)
{
    const SidedSurfaces valley{{test::valley(50, 50, 0.3)}};
    EXPECT_THROW(bound_of(valley, test::usual_problem()), GeometryError);
}

TEST(BoundGradeName, IsAWord)
{
    EXPECT_EQ(bound_grade_name(BoundGrade::Closed), "closed");
    EXPECT_EQ(bound_grade_name(BoundGrade::Certified), "certified");
    EXPECT_EQ(bound_grade_name(BoundGrade::Estimated), "estimated");
}

}  // namespace
}  // namespace endmill
