// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/covered_part.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

TEST(CoveredPart, CallsMovesClearThatEnterThePartByLessThanTheTolerance)
{
    const Part plane = std::vector<Surface>{test::plane(20, 10)};
    const CoveredPart part{plane, BallCutter{5}, {0.01, 0.1}};
    MoveTestState state;
    EXPECT_TRUE(part.is_clear({2, 5, 5}, {18, 5, 5}, state));
    EXPECT_TRUE(part.is_clear({2, 5, 4.995}, {18, 5, 4.995}, state));
    EXPECT_FALSE(part.is_clear({2, 5, 5}, {18, 5, 4.98}, state));
    EXPECT_EQ(part.cutter().radius(), 5);
    EXPECT_EQ(part.tolerance(), 0.01);
    EXPECT_TRUE(part.has_contacts_on_part());
}

TEST(CoveredPart, SamplesItsSurfaces)
{
    const Part plane = std::vector<Surface>{test::plane(20, 10)};
    const CoveredPart part{plane, BallCutter{5}, {0.01, 0.1}};
    const PartSamples samples = part.samples(1, 100'000);
    EXPECT_GE(samples.size(), 200u);
    EXPECT_THROW(part.samples(1, 100), LimitError);
}

TEST(CoveredPart, AimsAtLessOnAMeshWhoseEdgesTurn)
{
    const BallCutter ball{5};
    const Part plane = std::vector<Surface>{test::plane(20, 10)};
    EXPECT_EQ((CoveredPart{plane, ball, {0.01, 1}}.aimed_height(1)), 1);

    // A roof of two planes that rise by 1/200, so that its ridge turns by 0.01. At a height
    // of 1 mm cos a = 4/5 and sin a = 3/5; half of the turn counts.
    const std::vector<Vec3> points{{0, 0, 0},      {20, 0, 0}, {0, 10, 0.05},
                                   {20, 10, 0.05}, {0, 20, 0}, {20, 20, 0}};
    const std::vector<Triangle> facets{{0, 1, 3}, {0, 3, 2}, {2, 3, 5}, {2, 5, 4}};
    const Part roof = TriangleMesh{points, facets};
    const CoveredPart covered{roof, ball, {0.01, 1}};
    EXPECT_NEAR(covered.aimed_height(1), 1 - 0.01 / 2 * 0.6, 1e-6);
    EXPECT_FALSE(covered.has_contacts_on_part());
}

// Strips of a ball of 5 mm are 6 mm wide at a height of 1 mm, and 2 mm at about 0.1 mm.
TEST(FewSamples, KeepTheHeightIfTheySuffice)
{
    const Part part = std::vector<Surface>{test::plane(60, 30)};
    const BallCutter ball{5};
    const CoveredPart covered{part, ball, {0.01, 0.1}};
    const FewSamples few = few_samples(covered, {2, 10'000}, 0.1, 1'000'000);
    EXPECT_EQ(few.height, 0.1);
    EXPECT_GT(few.samples.size(), 1800u);
}

TEST(FewSamples, HaveAGreaterHeightIfTheyWouldBeTooMany)
{
    const Part part = std::vector<Surface>{test::plane(60, 30)};
    const BallCutter ball{5};
    const CoveredPart covered{part, ball, {0.01, 0.001}};
    const FewSamples few = few_samples(covered, {2, 10'000}, 0.001, 1'000'000);
    EXPECT_GT(few.height, 0.001);
    EXPECT_LE(few.samples.size(), 10'000u);
}

TEST(ScaledTravel, IsInverseToTheWidthOfStrips)
{
    const BallCutter ball{5};
    const double low = 5 - std::sqrt(25 - 0.09);  // strips of 0.6 mm
    EXPECT_NEAR(scaled_travel(100, ball, 1, low), 1000, 1e-9);
    EXPECT_NEAR(scaled_travel(100, ball, 1, 1), 100, 1e-12);
}

// On a plane of 24 cm^2 triangles with sides of 1 mm need at least about 2771 samples.
TEST(RequirePossible, RefusesAnAreaForTooManySamplesOnly)
{
    const Part part = std::vector<Surface>{test::plane(60, 40)};
    const CoveredPart covered{part, BallCutter{5}, {0.01, 0.5}};
    const double least = 2400 / (std::sqrt(3) / 2);
    EXPECT_NO_THROW(require_possible(covered, 1, static_cast<std::size_t>(least + 1)));
    EXPECT_THROW(require_possible(covered, 1, static_cast<std::size_t>(least - 1)),
                 LimitError);
    EXPECT_THROW(require_possible(covered, 1e-200, 1'000'000), LimitError);
    // the true number of samples is above the bound
    EXPECT_GT(covered.samples(1, 1'000'000).size(), least);
}

}  // namespace
}  // namespace endmill
