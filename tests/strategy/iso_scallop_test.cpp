// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/iso_scallop.h"

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/strategy/detail/coverage.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

StrategyOptions options_for(double height)
{
    StrategyOptions options;
    options.scallop_height = height;
    return options;
}

// The coverage is computed again from the passes, at the whole height.
TEST(IsoScallopPasses, CoverEverySample)
{
    const Part part = std::vector<Surface>{test::saddle(60, 25)};
    const BallCutter ball{4};
    const CoveredPart covered{part, ball, {0.01, 0.3}};
    const LaidPasses laid = iso_scallop_passes(covered, ball, options_for(0.3));
    Coverage coverage{laid.samples, ball, 0.3};
    for (const LaidPass& pass : laid.passes)
        coverage.add(pass.contacts, pass.is_closed);
    for (const double gap : coverage.gaps())
        EXPECT_LE(gap, 0);
}

TEST(IsoScallopPasses, RefuseTooManySamples)
{
    const Part part = std::vector<Surface>{test::plane(60, 40)};
    const BallCutter ball{5};
    const CoveredPart covered{part, ball, {0.01, 1e-6}};
    StrategyOptions options = options_for(1e-6);
    options.most_samples = 10'000;
    EXPECT_THROW(iso_scallop_passes(covered, ball, options), LimitError);
}

}  // namespace
}  // namespace endmill
