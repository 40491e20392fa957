// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/trimmed_planes.h"

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

// The resident memory of whole runs, as counted by the operating system.
TEST(TrimmingMemory, IsThatOfRunsWithinAFactorOfTwo)
{
    struct Run {
        TrimmingSize size;
        double bytes;
    };
    const std::vector<Run> runs{{{1, 20, 10'000}, 1.652e9},
                                {{1, 200, 2'000}, 0.615e9},
                                {{1, 20, 20'000, BoundaryContact::None}, 0.355e9},
                                {{1, 1000, 10}, 0.200e9},
                                {{1, 1000, 10, BoundaryContact::None}, 0.095e9},
                                {{1, 9000, 2, BoundaryContact::None}, 8.3e9}};
    for (const auto& [size, bytes] : runs) {
        EXPECT_LT(trimming_bytes(size), 2 * bytes)
            << size.planes << ' ' << size.grid_lines;
        EXPECT_GT(trimming_bytes(size), bytes / 2)
            << size.planes << ' ' << size.grid_lines;
    }
}

TEST(TrimmingMemory, RefusesOnlyWorkBeyondTheLimit)
{
    EXPECT_NO_THROW(require_trimming_memory({1, 200, 100}, 0.1));
    EXPECT_THROW(require_trimming_memory({1, 20'000, 100}, 8), LimitError);
    EXPECT_THROW(require_trimming_memory({0, 200, 10'000'000}, 8), LimitError);
}

}  // namespace
}  // namespace endmill
