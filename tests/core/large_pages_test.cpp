// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/detail/large_pages.h"

#include <array>
#include <numeric>

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(LargePages, KeepTheItemsAndReserveTheRoom)
{
    for (const std::size_t count : {0, 10, 3'000'000}) {
        std::vector<int> numbers{1, 2, 3};
        reserve_in_large_pages(numbers, count);
        EXPECT_EQ(numbers, (std::vector<int>{1, 2, 3}));
        EXPECT_GE(numbers.capacity(), count);
    }
}

TEST(LargePages, AreWrittenAndReadLikeOthers)
{
    std::vector<int> numbers;
    reserve_in_large_pages(numbers, 3'000'000);
    const int* place = numbers.data();
    numbers.resize(3'000'000);
    EXPECT_EQ(numbers.data(), place);
    EXPECT_EQ(std::accumulate(numbers.begin(), numbers.end(), 0LL), 0);
    std::iota(numbers.begin(), numbers.end(), 1);
    EXPECT_EQ(std::accumulate(numbers.begin(), numbers.end(), 0LL),
              3'000'000LL * 3'000'001 / 2);
}

TEST(LargePages, AreFilledWithCopies)
{
    for (const std::size_t count : {0, 10, 3'000'000}) {
        std::vector<int> numbers{1, 2, 3};
        assign_in_large_pages(numbers, count, 7);
        EXPECT_EQ(numbers, std::vector<int>(count, 7));
    }
}

TEST(LargePages, HaveNoEffectOnSmallAllocations)
{
    std::array<char, 100> few;
    few.fill('a');
    prefer_large_pages(few.data(), few.size());
    prefer_large_pages(few.data(), 0);
    EXPECT_EQ(few.front(), 'a');
    EXPECT_EQ(few.back(), 'a');
}

}  // namespace
}  // namespace endmill
