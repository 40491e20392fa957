// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/detail/finished_share.h"

#include <mutex>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/parallel.h"

namespace endmill {
namespace {

TEST(FinishedShare, IsReportedAtEveryStep)
{
    std::vector<double> shares;
    FinishedShare finished{[&](double share) { shares.push_back(share); }, 8, 4};
    for (const std::size_t more : {3, 1, 2, 2})
        finished.add(more);
    EXPECT_EQ(shares, (std::vector<double>{0.5, 1}));
}

TEST(FinishedShare, OfManyThreadsIsReportedOnceForEachItem)
{
    constexpr std::size_t items = 1000;
    std::mutex mutex;
    double sum = 0;
    FinishedShare finished{[&](double share) {
                               const std::lock_guard lock{mutex};
                               sum += share * items;
                           },
                           items};
    parallel_for(items, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            finished.add(1);
    });
    EXPECT_NEAR(sum, items * (items + 1) / 2.0, 1e-6);  // 1 + 2 + ... + items
}

TEST(FinishedShare, NeedsNoCallback)
{
    FinishedShare finished{{}, 2};
    EXPECT_NO_THROW(finished.add(1));
}

}  // namespace
}  // namespace endmill
