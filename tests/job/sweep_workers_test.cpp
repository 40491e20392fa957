// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/sweep_workers.h"

#include <gtest/gtest.h>

#include "fake_ranks.h"

namespace endmill {
namespace {

TEST(SweepWorkers, AreNoneInAProgramOfOneRank)
{
    OneRank one;
    const SweepWorkers workers{one};
    EXPECT_FALSE(workers.is_open());
}

TEST(SweepWorkers, GetOneAnswerForEachMessage)
{
    const auto ranks = FakeRanks::make(3);
    SweepWorkers workers{*ranks[0]};
    ranks[2]->send(0, "ready");
    const RankMessage message = workers.next();
    EXPECT_EQ(message.from, 2);
    EXPECT_EQ(message.content, "ready");
    workers.give(2, "work");
    EXPECT_EQ(ranks[2]->receive_from(0).content, "work");
    ranks[2]->send(0, "done");
    ranks[1]->send(0, "ready");
    workers.end(workers.next().from);
    EXPECT_TRUE(workers.is_open());
    workers.end(workers.next().from);
    EXPECT_FALSE(workers.is_open());
    EXPECT_EQ(ranks[1]->receive_from(0).content, "");
    EXPECT_EQ(ranks[2]->receive_from(0).content, "");
}

TEST(SweepWorkers, EndWithTheirOwner)
{
    const auto ranks = FakeRanks::make(3);
    ranks[1]->send(0, "ready");
    ranks[2]->send(0, "ready");
    {
        const SweepWorkers workers{*ranks[0]};
    }
    EXPECT_EQ(ranks[1]->receive_from(0).content, "");
    EXPECT_EQ(ranks[2]->receive_from(0).content, "");
}

}  // namespace
}  // namespace endmill
