// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/answer.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(Answer, OfADecidedQuestionIsYesOrNo)
{
    EXPECT_EQ(answer_of(true), Answer::Yes);
    EXPECT_EQ(answer_of(false), Answer::No);
    static_assert(answer_of(true) != Answer::Undecided);
}

}  // namespace
}  // namespace endmill
