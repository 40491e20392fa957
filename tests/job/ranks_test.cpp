// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/ranks.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(OneRank, IsTheOnlyOne)
{
    const OneRank ranks;
    EXPECT_EQ(ranks.rank(), 0);
    EXPECT_EQ(ranks.count(), 1);
}

TEST(OneRank, ReceivesNothing)
{
    EXPECT_FALSE(OneRank{}.receive(0.0));
}

TEST(OneRank, RefusesWhatNeedsAnotherOne)
{
    OneRank ranks;
    EXPECT_THROW(ranks.send(1, "text"), std::logic_error);
    EXPECT_THROW(ranks.receive(), std::logic_error);
    EXPECT_THROW(ranks.receive_from(1), std::logic_error);
}

}  // namespace
}  // namespace endmill
