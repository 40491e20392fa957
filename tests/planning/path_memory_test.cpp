// SPDX-License-Identifier: GPL-3.0-or-later
// tests/cli/plan_test.py measures that a path needs no more than this.
#include "endmill/planning/path_memory.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(MostPathPoints, FillTheMemoryUpToOnePoint)
{
    for (const double gib : {1e-9, 1e-6, 0.5, 1.0, 8.0, 1000.0}) {
        const double bytes = gib * 1024 * 1024 * 1024;
        const auto points = static_cast<double>(most_path_points(gib));
        EXPECT_LE(points * 900, bytes);
        EXPECT_GT((points + 1) * 900, bytes);
    }
}

TEST(MostPathPoints, HaveNoLimitInUnlimitedMemory)
{
    EXPECT_EQ(most_path_points(1e300), std::numeric_limits<std::size_t>::max());
}

TEST(PathMemory, RefusesOnlyPathsThatDoNotFitWithHalfThePoints)
{
    const auto most = static_cast<double>(most_path_points(0.25));
    EXPECT_NO_THROW(require_path_memory(0, 0.25));
    EXPECT_NO_THROW(require_path_memory(2 * most, 0.25));
    EXPECT_THROW(require_path_memory(2 * most + 1, 0.25), LimitError);
}

// 900 million points of 900 bytes are 810 * 10^9 / 2^30 = 754 GiB; 8 GiB hold 9.54
// million points.
TEST(PathMemory, ARefusalNamesPointsNeedAndLimit)
{
    EXPECT_THAT([] { require_path_memory(9e8, 8); },
                testing::ThrowsMessage<LimitError>(
                    AllOf(HasSubstr("about 9e+08 CL points"), HasSubstr("7.5e+02 GiB"),
                          HasSubstr("at most 8 GiB (--max-memory)"),
                          HasSubstr("enough for 9.5e+06 points"))));
}

}  // namespace
}  // namespace endmill
