// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/least_cones.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "endmill/core/parallel.h"
#include "endmill/visibility/sphere_grid.h"
#include "random_maps.h"

namespace endmill {
namespace {

bool holds(const DistinctCones& cones, std::size_t outer, std::size_t inner)
{
    for (std::size_t cell = 0; cell < cones.cells(); ++cell) {
        const auto has = [&](std::size_t cone) {
            return (cones.row(cone)[cell / 64] >> (cell % 64) & 1) != 0;
        };
        if (has(inner) && !has(outer))
            return false;
    }
    return true;
}

// Compares with a test of all pairs. Thousands of caps fill several tiles.
TEST(LeastCones, AreExactlyTheConesThatContainNoOther)
{
    test::Random random{4};
    const SphereGrid grid = sphere_grid("hex:6");
    for (const std::size_t facets : {1U, 40U, 2500U}) {
        const DistinctCones cones{test::random_caps(facets, grid.centres, random)};
        std::vector<std::size_t> expected;
        for (std::size_t outer = 0; outer < cones.size(); ++outer) {
            bool is_least = true;
            for (std::size_t inner = 0; inner < cones.size() && is_least; ++inner)
                is_least = inner == outer || !holds(cones, outer, inner);
            if (is_least)
                expected.push_back(outer);
        }
        const std::vector<std::size_t> by_size = least_cones(cones);
        std::vector<std::size_t> found = by_size;
        std::ranges::sort(found);
        EXPECT_EQ(found, expected);
        for (const int threads : {1, 8}) {
            set_thread_count(threads);
            EXPECT_EQ(least_cones(cones), by_size);
        }
    }
    set_thread_count(4);
}

TEST(LeastCones, MayBeEmpty)
{
    EXPECT_TRUE(least_cones(DistinctCones{VisibilityMap{3, 4}}).empty());
}

}  // namespace
}  // namespace endmill
