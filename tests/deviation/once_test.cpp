// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/once.h"

#include <atomic>
#include <stdexcept>

#include <gtest/gtest.h>

#include "endmill/core/parallel.h"

namespace endmill {
namespace {

TEST(Once, MakesOnceOnAnyNumberOfThreads)
{
    Once once;
    std::atomic<int> made = 0;
    std::atomic<int> seen = 0;
    set_thread_count(4);
    parallel_for(1000, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            once([&] { ++made; });
            seen += made;
        }
    });
    EXPECT_EQ(made, 1);
    EXPECT_EQ(seen, 1000);
}

TEST(Once, TriesAgainAfterAnException)
{
    Once once;
    int tries = 0;
    const auto make = [&] {
        if (++tries == 1)
            throw std::runtime_error{"no memory"};
    };
    EXPECT_THROW(once(make), std::runtime_error);
    once(make);
    once(make);
    EXPECT_EQ(tries, 2);
}

}  // namespace
}  // namespace endmill
