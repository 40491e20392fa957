// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/dropped_path.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/cutter/straight_sweep.h"
#include "endmill/planning/planner_options.h"
#include "endmill/strategy/strategy.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

StrategyOptions options_for(const std::vector<Surface>& surfaces)
{
    StrategyOptions options;
    options.scallop_height = 0.2;
    options.link.safe_height = default_safe_height(surfaces, Vec3::UnitZ());
    return options;
}

// A flat bottom of 10 mm leaves nothing between strips of 10 mm: 30 mm take 4 passes of
// 50 mm, and 50 mm take 6 of 30 mm, which is shorter.
TEST(DroppedPath, CutsALevelPlaneInStripsOfTheDiameter)
{
    const std::vector<Surface> surfaces{test::plane(50, 30)};
    const StrategyPlan plan = plan_by_strategy(Strategy::Planar, surfaces,
                                               Cutter::flat(5), options_for(surfaces));
    EXPECT_EQ(plan.verdict, Verdict::Clean);
    // besides these there may be short ones, shorter than one together
    EXPECT_GE(plan.economy.cut.tip_mm, 180 - 1e-9);
    EXPECT_LT(plan.economy.cut.tip_mm, 210);
    EXPECT_NEAR(plan.covering.direction->degrees(), 90, 1e-9);
}

// The corner of 2 mm leaves 0.16 mm or less (0.2 without the share of the chords) between
// strips 6 + 2 sqrt(h (4 - h)) mm apart.
TEST(DroppedPath, AddsTheStripOfTheCorner)
{
    const std::vector<Surface> surfaces{test::plane(50, 30)};
    StrategyOptions options = options_for(surfaces);
    options.direction = Angle::degrees(0);
    const StrategyPlan plan =
        plan_by_strategy(Strategy::Planar, surfaces, Cutter{5, 2}, options);
    const auto strip = [](double h) { return 6 + 2 * std::sqrt(h * (4 - h)); };
    EXPECT_EQ(plan.verdict, Verdict::Clean);
    // besides the whole passes there may be short ones, shorter than one together
    EXPECT_LT(plan.economy.cut.tip_mm, 50 * (std::ceil(30 / strip(0.16)) + 1));
    EXPECT_GE(plan.economy.cut.tip_mm, 50 * std::floor(30 / strip(0.2)));
    EXPECT_TRUE(plan.covering.compared.empty());
}

// The height that the moves of a path leave at (x, y), mm.
double left_height(const ToolPath& path, const Cutter& cutter, double x, double y)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k < path.points.size(); ++k)
        if (path.points[k].move == Move::Cut || path.points[k].move == Move::Link)
            least = std::min(least, StraightSweep{cutter, path.points[k - 1].location.tip,
                                                  path.points[k].location.tip}
                                        .height(x, y));
    return least;
}

// By the swept volumes of all moves, at places of a grid and above them.
TEST(DroppedPath, KeepsHeightAndToleranceOnCurvedParts)
{
    for (const double curvature : {-1.0 / 40, 1.0 / 40}) {
        const std::vector<Surface> surfaces{test::parabolic_cylinder(curvature, 20, 30)};
        StrategyOptions options = options_for(surfaces);
        options.direction = Angle::degrees(30);
        for (const Cutter& cutter : {Cutter::flat(4), Cutter{4, 1}}) {
            const ToolPath path = dropped_path(surfaces, cutter, options).path;
            for (int i = 1; i < 20; ++i)
                for (int j = 1; j < 20; ++j) {
                    const Surface& surface = surfaces.front();
                    const Interval u = surface.range(Parameter::U);
                    const Interval v = surface.range(Parameter::V);
                    const SurfaceTangents at =
                        surface.tangents(std::lerp(u.low, u.high, i / 20.0),
                                         std::lerp(v.low, v.high, j / 20.0));
                    Vec3 normal = at.du.cross(at.dv).normalized();
                    if (normal.z() < 0)
                        normal = -normal;
                    const Vec3 raised = at.point + options.scallop_height * normal;
                    // planes are placed by samples: 1.4 % more was seen, which the judge finds
                    EXPECT_LE(left_height(path, cutter, raised.x(), raised.y()),
                              raised.z() + 0.02 * options.scallop_height)
                        << cutter_word(cutter) << raised.transpose();
                    EXPECT_GE(left_height(path, cutter, at.point.x(), at.point.y()),
                              at.point.z() - options.inner_tolerance / normal.z());
                }
        }
    }
}

TEST(DroppedPath, OtherStrategiesRefuseTheCutter)
{
    const std::vector<Surface> surfaces{test::plane(50, 30)};
    EXPECT_THROW(plan_by_strategy(Strategy::IsoScallop, surfaces, Cutter::flat(5),
                                  options_for(surfaces)),
                 GeometryError);
}

TEST(DroppedPath, RefusesASafeHeightBelowThePath)
{
    const std::vector<Surface> surfaces{test::plane(50, 30)};
    StrategyOptions options = options_for(surfaces);
    options.link.order = PassOrder::OneWay;
    options.link.safe_height = -1;
    EXPECT_THROW(dropped_path(surfaces, Cutter::flat(5), options), GeometryError);
}

}  // namespace
}  // namespace endmill
