// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/path_error.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "endmill/planning/detail/contact_line.h"
#include "endmill/planning/iso_parametric.h"
#include "revolved_surfaces.h"
#include "swept_deviation.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr double rho = 20;
constexpr double radius = 5;
using std::numbers::pi;

// Passes across a cylinder, outside or inside, whose chords keep the tolerance delta.
MotionError error_on_cylinder(double from, double to, double delta)
{
    const std::vector<Surface> part{nurbs_surface(test::cylinder(rho, 30, from, to))};
    IsoParametricOptions options;
    options.direction = Parameter::V;
    options.chord_tolerance = delta;
    const BallCutter ball{radius};
    const ToolPath path = plan_iso_parametric(part, ball, options).path;
    return motion_error(part, path, ball, Parameter::V);
}

// The chord between contacts has the sagitta delta if its half angle is acos(1 - delta /
// rho). The centres lie on a circle that is larger outside and smaller inside.
TEST(MotionError, OnACylinderIsTheSagittaOfTheCentres)
{
    for (const double delta : {0.02, 0.2}) {
        const MotionError outside = error_on_cylinder(pi / 6, 5 * pi / 6, delta);
        EXPECT_NEAR(outside.gouge.greatest_mm, delta * (1 + radius / rho),
                    outside.bound_mm);
        EXPECT_LT(outside.remaining.greatest_mm, 1e-12);
        const MotionError inside = error_on_cylinder(7 * pi / 6, 11 * pi / 6, delta);
        EXPECT_NEAR(inside.remaining.greatest_mm, delta * (1 - radius / rho),
                    inside.bound_mm);
        EXPECT_LT(inside.gouge.greatest_mm, 1e-12);
        EXPECT_EQ(inside.greatest_mm(), inside.remaining.greatest_mm);
    }
}

TEST(MotionError, OnAPlaneIsZero)
{
    const std::vector<Surface> part{test::parallelogram({40, 10, 20}, {0, 30, 5})};
    const BallCutter ball{radius};
    const ToolPath path = plan_iso_parametric(part, ball, {}).path;
    EXPECT_LT(motion_error(part, path, ball, Parameter::U).greatest_mm(), 1e-12);
}

// Deviations at dense samples of every line, computed without bounds.
TEST(MotionError, IsTheGreatestOfDenseSamples)
{
    const std::vector<Surface> part{test::random_surface(8, {2, 2}, 2),
                                    test::random_surface(9, {1, 2}, 2)};
    const BallCutter ball{1};
    for (const Parameter along : {Parameter::U, Parameter::V}) {
        IsoParametricOptions options;
        options.direction = along;
        options.chord_tolerance = options.scallop_height = 0.1;
        options.link.safe_height = 50;
        const ToolPath path = plan_iso_parametric(part, ball, options).path;
        double gouge = 0;
        double left = 0;
        for (std::size_t k = 1; k < path.points.size(); ++k) {
            const PathPoint& to = path.points[k];
            if (to.move != Move::Cut)
                continue;
            const PathPoint& from = path.points[k - 1];
            const test::SampledMove move{from.location.tip + Vec3::UnitZ(),
                                         to.location.tip + Vec3::UnitZ()};
            for (int s = 0; s <= 800; ++s) {
                const double u = std::lerp(from.contact()->u, to.contact()->u, s / 800.0);
                const double v = std::lerp(from.contact()->v, to.contact()->v, s / 800.0);
                const double e =
                    test::distance_to(part[to.patch].tangents(u, v).point, move) - 1;
                gouge = std::max(gouge, -e);
                left = std::max(left, e);
            }
        }
        const MotionError error = motion_error(part, path, ball, along);
        EXPECT_NEAR(error.gouge.greatest_mm, gouge, 4e-3 * gouge);
        EXPECT_NEAR(error.remaining.greatest_mm, left, 4e-3 * left);
        EXPECT_GE(error.gouge.greatest_mm + error.bound_mm, gouge);
        EXPECT_GE(error.remaining.greatest_mm + error.bound_mm, left);
        const auto& [greatest, at, patch] = error.remaining;
        EXPECT_GT(greatest, 0);
        EXPECT_TRUE(patch == 0 || patch == 1);
    }
}

TEST(MotionError, OfNoCutIsZero)
{
    const std::vector<Surface> part{test::plane(10, 10)};
    EXPECT_EQ(motion_error(part, {}, BallCutter{1}, Parameter::U).greatest_mm(), 0);
}

TEST(PathErrors, TakeTheDeeperGouge)
{
    const ChordError chord{.greatest_mm = 0.3, .pitch_mm = 0.1, .at = {}};
    for (const double along_pass : {0.01, 0.2}) {
        const MotionError motion{{along_pass}, {0.5}, 1e-6};
        const PathErrors errors = path_errors(chord, motion, 0.1, 0.4);
        EXPECT_EQ(errors.chord, 0.3);
        EXPECT_EQ(errors.gouge, along_pass > 0.1 ? along_pass : 0.1);
        EXPECT_EQ(errors.scallop, 0.4);
    }
}

TEST(MissedLimits, AreThoseThatAnErrorExceeds)
{
    using enum PathLimit;
    const PathErrors limits{0.1, 0.2, 0.3};
    const auto missed = [&](double chord, double gouge, double scallop) {
        return missed_limits({chord, gouge, scallop}, limits);
    };
    EXPECT_EQ(missed(0.1, 0.2, 0.3), std::set<PathLimit>{});
    EXPECT_EQ(missed(0.11, 0.2, 0.3), std::set{Chord});
    EXPECT_EQ(missed(0, 0.21, 0), std::set{Gouge});
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(missed(1, 1, infinity), (std::set{Chord, Gouge, Scallop}));
}

}  // namespace
}  // namespace endmill
