// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/word_checksum.h"

#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace endmill {
namespace {

std::uint64_t sum_of(const std::vector<std::uint64_t>& words)
{
    WordChecksum sum;
    for (const std::uint64_t word : words)
        sum.add(word);
    return sum.sum();
}

TEST(WordChecksum, TellsOfEachBitOfEachWordAndOfTheirOrderAndNumber)
{
    const std::vector<std::uint64_t> words{0, 1, 2, 0, 0};
    std::set<std::uint64_t> sums{sum_of(words)};
    for (std::size_t k = 0; k < words.size(); ++k)
        for (int bit = 0; bit < 64; ++bit) {
            std::vector<std::uint64_t> changed = words;
            changed[k] ^= std::uint64_t{1} << bit;
            sums.insert(sum_of(changed));
        }
    sums.insert(sum_of({1, 0, 2, 0, 0}));
    sums.insert(sum_of({0, 1, 2, 0}));
    sums.insert(sum_of({0, 1, 2, 0, 0, 0}));
    sums.insert(sum_of({}));
    // Of the changes of one bit, 0 1 2 0 0 to 1 1 2 0 0 and so on, none is another of these.
    EXPECT_EQ(sums.size(), 1 + 5 * 64 + 4U);
}

TEST(WordChecksum, IsThatOfTheWordsThatBytesAre)
{
    const std::vector<std::uint64_t> words{7, 0x0123456789abcdef};
    const std::string_view bytes{reinterpret_cast<const char*>(words.data()), 16};
    WordChecksum sum;
    sum.add(bytes);
    EXPECT_EQ(sum.sum(), sum_of(words));
    EXPECT_THROW(sum.add(bytes.substr(1)), DomainError);
}

TEST(WordChecksum, FillsUpToWholeWords)
{
    for (std::size_t bytes = 0; bytes < 40; ++bytes) {
        EXPECT_EQ(whole_words(bytes) % 8, 0U);
        EXPECT_GE(whole_words(bytes), bytes);
        EXPECT_LT(whole_words(bytes), bytes + 8);
    }
}

}  // namespace
}  // namespace endmill
