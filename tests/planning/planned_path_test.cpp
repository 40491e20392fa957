// SPDX-License-Identifier: GPL-3.0-or-later
// tests/cli/plan_test.py measures that a path needs no more memory than is stated.
#include "endmill/planning/planned_path.h"

#include <array>
#include <cmath>
#include <limits>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/planning/iso_parametric.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// Passes along v over a plane of 60 by 30 mm, with a ball of radius 5.
constexpr double plane_scallop = 0.5;
const std::vector<Surface> plane_part{test::plane(60, 30)};
const BallCutter plane_ball{5};

PlannerOptions plane_options(Planner planner)
{
    if (planner == Planner::Paper)
        return IsoParametricOptions{.direction = Parameter::V,
                                    .chord_tolerance = 0.1,
                                    .scallop_height = plane_scallop};
    return VerifiedOptions{.direction = Parameter::V,
                           .tolerances = {0.1, 0.2},
                           .scallop_height = plane_scallop};
}

// Number of passes whose intervals of 2 sqrt(2 R h - h^2) cover the width, and the last
// border. The verified planner uses 0.999 of the plane_scallop height.
double passes_on_the_plane(double share)
{
    const double h = share * plane_scallop;
    return std::ceil(60 / (2 * std::sqrt(2 * 5 * h - h * h))) + 1;
}

TEST(PlanPath, ByEitherPlannerHasThePassesOfTheClosedForm)
{
    const PlannedPath paper =
        plan_path(plane_part, plane_ball, plane_options(Planner::Paper));
    EXPECT_EQ(double(paper.path.points.size()), 2 * passes_on_the_plane(1));
    const PlannedPath verified =
        plan_path(plane_part, plane_ball, plane_options(Planner::Verified));
    EXPECT_EQ(double(verified.path.points.size()), 2 * passes_on_the_plane(0.999));
    for (const PlannedPath& plan : {paper, verified})
        EXPECT_EQ(plan.path.points.back().contact()->u, 1);
}

TEST(PlanPath, ReportsUncoveredPlacesOfTheVerifiedPlannerOnly)
{
    const PlannedPath paper =
        plan_path(plane_part, plane_ball, plane_options(Planner::Paper));
    EXPECT_FALSE(paper.uncovered);
    EXPECT_FALSE(paper.is_proved());
    PlannedPath verified =
        plan_path(plane_part, plane_ball, plane_options(Planner::Verified));
    ASSERT_TRUE(verified.uncovered);
    EXPECT_TRUE(verified.is_proved());
    verified.uncovered = {{0, {0.5, 0.5}, Vec3::Zero()}};
    EXPECT_FALSE(verified.is_proved());
}

TEST(EstimatedPoints, OfSeveralSurfacesAreThoseOfEach)
{
    const std::vector<Surface> two{test::plane(60, 30), test::plane(20, 40)};
    for (const Planner planner : {Planner::Paper, Planner::Verified}) {
        const PlannerOptions options = plane_options(planner);
        const double first = estimated_points({two.data(), 1}, plane_ball, options);
        const double second = estimated_points({two.data() + 1, 1}, plane_ball, options);
        EXPECT_DOUBLE_EQ(estimated_points(two, plane_ball, options), first + second);
        const auto found =
            double(plan_path(plane_part, plane_ball, options).path.points.size());
        EXPECT_LT(std::abs(std::log2(first / found)), std::log2(2.5));
    }
}

TEST(MostPathPoints, FillTheMemoryUpToOnePoint)
{
    for (const double gib : {1e-9, 1e-6, 0.5, 1.0, 8.0, 1000.0}) {
        const double bytes = gib * 1024 * 1024 * 1024;
        const auto points = static_cast<double>(most_path_points(gib));
        EXPECT_LE(points * 1000, bytes);
        EXPECT_GT((points + 1) * 1000, bytes);
    }
}

TEST(MostPathPoints, HaveNoLimitInUnlimitedMemory)
{
    EXPECT_EQ(most_path_points(1e300), std::numeric_limits<std::size_t>::max());
}

TEST(PathMemory, RefusesOnlyPathsThatDoNotFitWithHalfThePoints)
{
    const auto most = static_cast<double>(most_path_points(0.25));
    EXPECT_NO_THROW(require_path_memory(0, 0.25));
    EXPECT_NO_THROW(require_path_memory(2 * most, 0.25));
    EXPECT_THROW(require_path_memory(2 * most + 1, 0.25), LimitError);
}

// 900 million points of 1000 bytes are 9 * 10^11 / 2^30 = 838 GiB; 8 GiB hold 8.59
// million points.
TEST(PathMemory, ARefusalNamesPointsNeedAndLimit)
{
    EXPECT_THAT([] { require_path_memory(9e8, 8); },
                testing::ThrowsMessage<LimitError>(
                    AllOf(HasSubstr("about 9e+08 CL points"), HasSubstr("8.4e+02 GiB"),
                          HasSubstr("at most 8 GiB (--max-memory)"),
                          HasSubstr("enough for 8.6e+06 points"))));
}

// 2 points of 1000 bytes are 1.9e-6 GiB.
TEST(PathMemory, APathThatGrowsBeyondItNamesNeedAndLimit)
{
    for (const Planner planner : {Planner::Paper, Planner::Verified}) {
        PlannerOptions options = plane_options(planner);
        std::visit([](auto& own) { own.most_points = 2; }, options);
        EXPECT_THAT([&] { plan_path(plane_part, plane_ball, options); },
                    testing::ThrowsMessage<LimitError>(
                        AllOf(HasSubstr("more than 2 points"), HasSubstr(" would need "),
                              HasSubstr("at most 1.9e-06 GiB (--max-memory)"),
                              HasSubstr("larger tolerances need fewer points"))));
    }
}

// A quarter of 0.5 GiB holds 134217 points of 1000 bytes.
TEST(FitTogether, IfTheSumNeedsAtMostAQuarterOfTheMemory)
{
    EXPECT_TRUE(fit_together(std::array{100'000.0, 34'217.0}, 0.5));
    EXPECT_FALSE(fit_together(std::array{100'000.0, 34'218.0}, 0.5));
    EXPECT_TRUE(fit_together({}, 0.5));
}

TEST(FitTogether, RefusesAPathThatIsTooLongAlone)
{
    const auto most = static_cast<double>(most_path_points(0.5));
    EXPECT_FALSE(fit_together(std::array{1.0, 2 * most}, 0.5));
    EXPECT_THROW(fit_together(std::array{1.0, 2 * most + 1}, 0.5), LimitError);
}

}  // namespace
}  // namespace endmill
