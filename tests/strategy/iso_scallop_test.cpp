// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/iso_scallop.h"

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/planning/planner_options.h"
#include "endmill/strategy/detail/section_march.h"
#include "endmill/strategy/strategy.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

StrategyOptions iso_scallop_options(const Part& part, double height)
{
    StrategyOptions options;
    options.scallop_height = height;
    options.link.safe_height =
        default_safe_height(std::get<std::vector<Surface>>(part), Vec3::UnitZ());
    return options;
}

StrategyPlan iso_scallop_plan(const Part& part, double height)
{
    return plan_by_strategy(Strategy::IsoScallop, part, BallCutter{5},
                            iso_scallop_options(part, height));
}

// Strips of 6 mm: 30 mm need five passes of 60 mm, and a sixth for the reserve.
TEST(IsoScallopPasses, OfAPlaneAreNotLongerThanStraightStrips)
{
    const StrategyPlan found =
        iso_scallop_plan(std::vector<Surface>{test::plane(60, 30)}, 1);
    EXPECT_TRUE(found.is_good());
    EXPECT_LE(found.economy.cut.contact_mm, 1.02 * 6 * 60);
}

TEST(IsoScallopPasses, AreJudgedCleanOnASaddle)
{
    const StrategyPlan found =
        iso_scallop_plan(std::vector<Surface>{test::saddle(40, 20)}, 0.3);
    EXPECT_TRUE(found.is_good());
    EXPECT_TRUE(found.covering.uncovered.empty());
}

// The start is chosen at a greater height, which needs fewer samples.
TEST(IsoScallopPasses, AreJudgedCleanAtALowHeight)
{
    const StrategyPlan found =
        iso_scallop_plan(std::vector<Surface>{test::saddle(40, 5)}, 0.01);
    EXPECT_TRUE(found.is_good());
}

TEST(IsoScallopPasses, CoverTheSamplesOnWhichTheyAreLaid)
{
    const Part part = std::vector<Surface>{test::saddle(40, 20)};
    const BallCutter ball{5};
    const CoveredPart covered{part, ball, {0.01, 0.3}};
    const StrategyOptions options = iso_scallop_options(part, 0.3);
    const LaidPasses laid = iso_scallop_passes(covered, ball, options,
                                               scallop_starts(covered, ball, options));
    // a ball at a contact of a pass is near enough to the raised point of each sample
    for (std::size_t i = 0; i < laid.samples.size(); ++i) {
        const Vec3 raised = laid.samples.point(i) + 0.3 * laid.samples.normal(i);
        double least = 1000;
        for (const LaidPass& pass : laid.passes)
            for (const PassContact& contact : pass.contacts)
                least = std::min(least, (ball_centre(contact.at, ball) - raised).norm());
        EXPECT_LT(least, 5.05);
    }
}

// At the lower height the trials use a greater one. Their estimate is about the area in
// strips, and about the length of the passes that are laid.
TEST(ScallopStarts, EstimateTheLengthOfThePasses)
{
    const Part part = std::vector<Surface>{test::saddle(60, 20)};
    const BallCutter ball{5};
    for (const double height : {0.3, 0.01}) {
        const StrategyOptions options = iso_scallop_options(part, height);
        const CoveredPart covered{part, ball, {options.inner_tolerance, height}};
        const ScallopStarts starts = scallop_starts(covered, ball, options);
        const LaidPasses laid = iso_scallop_passes(covered, ball, options, starts);
        const double length = pass_lengths(laid.passes, ball.radius()).contact_mm;
        EXPECT_NEAR(starts.travel / length, 1, 0.1) << height;
        EXPECT_NEAR(starts.travel * strip_width(ball, height) / 1770, 1, 0.15) << height;
    }
}

TEST(IsoScallopPasses, RefuseMoreSamplesThanTheLimit)
{
    const Part part = std::vector<Surface>{test::plane(100, 100)};
    StrategyOptions options = iso_scallop_options(part, 1e-3);
    options.most_samples = 10'000;
    const BallCutter ball{5};
    const CoveredPart covered{part, ball, {options.inner_tolerance, 1e-3}};
    EXPECT_THROW(iso_scallop_passes(covered, ball, options, {{BorderStart{0, 1}}, 0}),
                 LimitError);
}

}  // namespace
}  // namespace endmill
