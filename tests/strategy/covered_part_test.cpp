// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/covered_part.h"

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
}

TEST(CoveredPart, SamplesItsSurfaces)
{
    const Part plane = std::vector<Surface>{test::plane(20, 10)};
    const CoveredPart part{plane, BallCutter{5}, {0.01, 0.1}};
    const PartSamples samples = part.samples(1, 100'000);
    EXPECT_GE(samples.size(), 200u);
    EXPECT_THROW(part.samples(1, 100), LimitError);
}

}  // namespace
}  // namespace endmill
