// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/step_study.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "endmill/planning/iso_parametric.h"
#include "endmill/surface/nurbs.h"
#include "revolved_surfaces.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

const PassSettings around{BallCutter{3}, 0.05, Parameter::V};

// A quarter of a cylinder of radius 20 with its axis along x, seen from above.
Surface quarter()
{
    return nurbs_surface(test::cylinder(20, 12, 0.8, 2.3));
}

ToolPath path_around(const Surface& surface)
{
    IsoParametricOptions options;
    options.direction = around.direction;
    options.chord_tolerance = around.tolerance;
    options.scallop_height = 0.2;
    return plan_iso_parametric(surface, around.ball, options).path;
}

// The chord between two points of a circle strays by the sagitta of its length.
TEST(StepStudy, OnACylinderHasTheSagittaAsChordError)
{
    const Surface surface = quarter();
    const ToolPath path = path_around(surface);
    const std::vector<StepErrors> errors = step_errors(surface, path, around);
    std::size_t number = 0;
    for (std::size_t k = 1; k < path.points.size(); ++k) {
        if (path.points[k].move != Move::Cut)
            continue;
        const double chord = (path.points[k].contact()->contact.point -
                              path.points[k - 1].contact()->contact.point)
                                 .norm();
        const double sagitta = 20 - std::sqrt(400 - chord * chord / 4);
        ASSERT_LT(number, errors.size());
        EXPECT_NEAR(errors[number].chord, sagitta, 1e-6);
        ++number;
    }
    EXPECT_EQ(number, errors.size());
}

// Outside a cylinder the straight motion of the ball gouges by (R + r) (1 - cos) of half a step.
TEST(StepStudy, OnACylinderHasTheSagittaOfTheCentresAsGouge)
{
    const Surface surface = quarter();
    const ToolPath path = path_around(surface);
    const std::vector<StepErrors> errors = step_errors(surface, path, around);
    const double chord = (path.points[1].contact()->contact.point -
                          path.points[0].contact()->contact.point)
                             .norm();
    const double half = std::asin(chord / 40);
    EXPECT_NEAR(errors.front().gouge, 23 * (1 - std::cos(half)), 1e-5);
}

TEST(StepStudy, RolledPathHasThePiecesAndTheSagittaOfEach)
{
    const Surface surface = quarter();
    const ToolPath path = path_around(surface);
    const ToolPath rolled = rolled_path(surface, path, around.ball, 4);
    const auto cuts = [](const ToolPath& some) {
        return std::ranges::count(some.points, Move::Cut, &PathPoint::move);
    };
    EXPECT_EQ(cuts(rolled), 4 * cuts(path));
    for (const PathPoint& point : rolled.points)
        if (point.contact()) {
            const Vec3& at = point.contact()->contact.point;
            EXPECT_NEAR(std::hypot(at.y(), at.z()), 20, 1e-12);
        }
}

// The longest chord with the tolerance as sagitta: 2 sqrt(2 R d - d^2).
TEST(StepStudy, GreedyPointsOfACircleFollowFromTheLongestChord)
{
    const Surface surface = quarter();
    const ToolPath path = path_around(surface);
    const std::size_t passes = static_cast<std::size_t>(path.points.back().pass) + 1;
    const double chord = 2 * std::sqrt(2 * 20 * 0.05 - 0.05 * 0.05);
    const double step = 2 * std::asin(chord / 40);
    const auto steps = static_cast<std::size_t>(std::ceil(1.5 / step));
    EXPECT_EQ(greedy_points(surface, path, around, {}), passes * (steps + 1));
    EXPECT_EQ(greedy_points(surface, path, around, {.longest = LongestStep::Paper}),
              passes * (steps + 1))
        << "the paper's step is exact on a circle";
    EXPECT_GT(greedy_points(surface, path, around,
                            {.limited = LimitedCurves::ContactsAndCentres}),
              passes * (steps + 1))
        << "the centres lie on a larger circle";
}

TEST(StepStudy, OnAPlanePassesHaveTwoPoints)
{
    const Surface plane = test::plane(20, 10);
    IsoParametricOptions options;
    options.direction = Parameter::V;
    const ToolPath path = plan_iso_parametric(plane, around.ball, options).path;
    const std::size_t passes = static_cast<std::size_t>(path.points.back().pass) + 1;
    EXPECT_EQ(greedy_points(plane, path, around,
                            {.limited = LimitedCurves::ContactsAndCentres}),
              2 * passes);
    EXPECT_EQ(verified_points(plane, path, around), 2 * passes);
}

}  // namespace
}  // namespace endmill
