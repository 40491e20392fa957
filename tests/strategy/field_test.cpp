// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/field.h"

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/planning/planner_options.h"
#include "endmill/strategy/detail/section_march.h"
#include "endmill/strategy/strategy.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

StrategyOptions options_for(const Part& part, double height)
{
    StrategyOptions options;
    options.scallop_height = height;
    options.link.safe_height =
        default_safe_height(std::get<std::vector<Surface>>(part), Vec3::UnitZ());
    return options;
}

// A hill on which contacts go farther around than along: its strips are as wide as on a
// plane around it, and narrower along it.
TEST(FieldPasses, RunAroundAConvexCylinder)
{
    const Part part = std::vector<Surface>{test::parabolic_cylinder(-1.0 / 20, 8, 40)};
    const StrategyOptions options = options_for(part, 0.4);
    const BallCutter ball{5};
    const CoveredPart covered{part, ball, {options.inner_tolerance, 0.4}};
    const LaidPasses laid = field_passes(covered, ball, options);
    for (const LaidPass& pass : laid.passes) {
        const Vec3 way = pass.contacts.back().at.contact.point -
                         pass.contacts.front().at.contact.point;
        EXPECT_GT(std::abs(way.x()), 20 * std::abs(way.y()));
    }
    // 40 mm in strips of 3.92 mm, at 0.97 of the height
    EXPECT_EQ(laid.passes.size(), 11u);
    // trials on few samples find about the same length
    EXPECT_NEAR(field_travel(covered, ball, options) /
                    pass_lengths(laid.passes, ball.radius()).contact_mm,
                1, 0.1);
}

TEST(FieldPasses, AreJudgedClean)
{
    const Part part = std::vector<Surface>{test::saddle(40, 20)};
    const StrategyPlan plan =
        plan_by_strategy(Strategy::Field, part, BallCutter{5}, options_for(part, 0.3));
    EXPECT_TRUE(plan.is_good());
}

TEST(FieldPasses, RefuseMoreSamplesThanTheGuideCanHave)
{
    const Part part = std::vector<Surface>{test::plane(100, 100)};
    const StrategyOptions options = options_for(part, 1e-5);
    const BallCutter ball{5};
    const CoveredPart covered{part, ball, {options.inner_tolerance, 1e-5}};
    try {
        field_passes(covered, ball, options);
        FAIL() << "no error";
    } catch (const LimitError& error) {
        // it is not the memory that is short
        EXPECT_STREQ(
            error.what(),
            "the part would need more than 400000 samples at this scallop height, "
            "the most with which field plans; expected a larger --scallop or "
            "another --strategy");
    }
}

}  // namespace
}  // namespace endmill
