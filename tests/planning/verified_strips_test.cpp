// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/verified_strips.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "revolved_surfaces.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr double radius = 5;

VerifiedStrips strips_of(const Surface& part, double side, const VerifiedOptions& options)
{
    const MarchedSurface marched{part, side};
    const ClearMoves clear{{&part, 1},
                           {&side, 1},
                           BallCutter{radius},
                           Vec3::UnitZ(),
                           options.tolerances.inner};
    return verified_strips(marched, clear, options);
}

VerifiedOptions options_with(double inner, double outer, double scallop)
{
    VerifiedOptions options;
    options.tolerances = {inner, outer};
    options.scallop_height = scallop;
    return options;
}

TEST(VerifiedStrips, OnAPlaneLieTheClosedFormApart)
{
    for (const double h : {0.01, 0.4, 2.0, 7.0}) {  // above R the widest is 2 R
        const double lowered = std::min(h, radius);
        const double interval = 2 * std::sqrt(2 * radius * lowered - lowered * lowered);
        const VerifiedStrips strips =
            strips_of(test::plane(40, 100), 1, options_with(0.1, 0.1, h));
        EXPECT_TRUE(strips.uncovered.empty());
        const auto& passes = strips.passes;
        ASSERT_GE(passes.size(), 3U);
        EXPECT_EQ(passes.front().v, 0);
        EXPECT_EQ(passes.back().v, 1);
        for (std::size_t k = 1; k + 1 < passes.size(); ++k) {
            EXPECT_NEAR(100 * (passes[k].v - passes[k - 1].v), interval, 0.01 * interval);
        }
    }
}

TEST(VerifiedStrips, ConvergeOnAPole)
{
    const VerifiedStrips strips =
        strips_of(nurbs_surface(test::torus(0, 20, {0, 1.5, 0.5, std::numbers::pi / 2})),
                  1, options_with(0.05, 0.05, 0.1));
    EXPECT_TRUE(strips.uncovered.empty());
    EXPECT_EQ(swept(strips.passes.back(), BallCutter{radius}).size(), 1U);
}

// No ball reaches the crease of a valley. The remaining material there is R (1 / cos tilt
// - 1), less a little for the inner tolerance. It exceeds the scallop height plus the
// outer tolerance.
TEST(VerifiedStrips, ReportACreaseAndContinue)
{
    const Surface valley = test::valley(30, 20, 1);
    for (const Surface& part : {valley, transposed(valley)}) {
        const VerifiedStrips strips =
            strips_of(part, part.patches(Parameter::U) == 2 ? 1 : -1,
                      options_with(0.05, 0.05, 0.05));
        EXPECT_FALSE(strips.uncovered.empty());
        for (const SurfacePoint& at : strips.uncovered) {
            const Vec3 point = part.tangents(at.u, at.v).point;
            EXPECT_LT(std::abs(point.x()), radius);
        }
        EXPECT_LT(strips.passes.size(), 200U);
    }
}

TEST(VerifiedStrips, StopAtTheMostPoints)
{
    VerifiedOptions options = options_with(0.1, 0.1, 1e-4);
    options.most_points = 100;
    EXPECT_THROW(strips_of(test::plane(40, 100), 1, options), LimitError);
}

}  // namespace
}  // namespace endmill
