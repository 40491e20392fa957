// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/joined_rows.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace endmill {
namespace {

class JoinedRows : public testing::TestWithParam<std::size_t> {};

TEST_P(JoinedRows, AreEachRowOnceInOrder)
{
    std::string expected = "head\n";
    for (std::size_t i = 0; i < GetParam(); ++i)
        expected += std::to_string(i) + "\n";
    const std::string joined =
        joined_rows("head\n", GetParam(), [](std::size_t first, std::size_t count) {
            EXPECT_LE(count, 512U);
            std::string text;
            for (std::size_t i = first; i < first + count; ++i)
                text += std::to_string(i) + "\n";
            return text;
        });
    EXPECT_TRUE(joined == expected);  // not EXPECT_EQ, which would print both
}

INSTANTIATE_TEST_SUITE_P(OfAnyNumber, JoinedRows,
                         testing::Values(0, 1, 512, 513, 32768, 32769, 300'000));

TEST(PassTexts, PassesEachTextOnInOrder)
{
    std::vector<std::string> passed;
    pass_texts(
        1000, [](std::size_t i) { return std::to_string(i); },
        [&](std::string_view text) { passed.emplace_back(text); });
    ASSERT_EQ(passed.size(), 1000U);
    for (std::size_t i = 0; i < passed.size(); ++i)
        EXPECT_EQ(passed[i], std::to_string(i));
}

}  // namespace
}  // namespace endmill
