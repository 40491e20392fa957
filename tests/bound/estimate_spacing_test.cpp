// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/estimate_spacing.h"

#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

TEST(SurfaceSpacing, IsAShareOfTheWidthOfTheDisc)
{
    const BoundProblem problem{BallCutter{7.5}, 0.5};
    const double width = 2 * plane_half_width(problem);
    EXPECT_DOUBLE_EQ(surface_spacing(1, problem), 0.35 * width);
    EXPECT_DOUBLE_EQ(surface_spacing(1e6, problem), 0.7 * width);
    EXPECT_DOUBLE_EQ(surface_spacing(4000 * width * width / 4, problem), 0.5 * width);
}

TEST(EstimateSpacing, LimitsTheNumberOfNodesAndRefusesWhatIsNoSpacing)
{
    EXPECT_EQ(estimate_spacing(1, 0.3, 1000), 0.3);
    EXPECT_DOUBLE_EQ(estimate_spacing(30000, 0.3, 1000), 1);
    for (const double wrong : {0.0, -1.0, std::numeric_limits<double>::infinity()})
        EXPECT_THROW(estimate_spacing(1, wrong, 1000), DomainError);
    EXPECT_THROW(estimate_spacing(1, 0.3, 999), DomainError);
}

TEST(PositiveBound, IsNothingOnASmallPart)
{
    EXPECT_EQ(positive_bound(10, 4, 2), 2);
    EXPECT_EQ(positive_bound(8, 4, 2), std::nullopt);
}

}  // namespace
}  // namespace endmill
