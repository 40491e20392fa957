// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/detail/disjoint_sets.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

TEST(DisjointSets, AreAtFirstOneForEachNumber)
{
    DisjointSets sets{3};
    for (int k = 0; k < 3; ++k)
        EXPECT_EQ(sets.least(k), k);
}

TEST(DisjointSets, ReportWhetherTwoBecameOne)
{
    DisjointSets sets{4};
    EXPECT_TRUE(sets.join(3, 1));
    EXPECT_TRUE(sets.join(0, 2));
    EXPECT_FALSE(sets.join(1, 3));
    EXPECT_FALSE(sets.join(2, 2));
    EXPECT_TRUE(sets.join(2, 3));
    EXPECT_EQ(sets.least(3), 0);
}

// The second route gives every set a colour and recolours one set when two are joined.
TEST(DisjointSets, AgreeWithRecolouring)
{
    test::Random random{1};
    constexpr int count = 200;
    DisjointSets sets{count};
    std::vector<int> colours(count);
    std::iota(colours.begin(), colours.end(), 0);
    for (int step = 0; step < 150; ++step) {
        const int a = static_cast<int>(random.uniform(0, count));
        const int b = static_cast<int>(random.uniform(0, count));
        sets.join(a, b);
        std::ranges::replace(colours, int{colours[a]}, int{colours[b]});
    }
    for (int k = 0; k < count; ++k) {
        const auto first = std::ranges::find(colours, colours[k]);
        EXPECT_EQ(sets.least(k), first - colours.begin());
    }
}

}  // namespace
}  // namespace endmill
