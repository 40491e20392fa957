// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/bit_transpose.h"

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

TEST(BitTranspose, SwapsRowsAndColumns)
{
    test::Random random{3};
    BitBlock block;
    for (std::uint64_t& word : block)
        word = std::uint64_t{random.engine()()} << 32 | random.engine()();
    BitBlock turned = block;
    transpose(turned);
    for (std::size_t i = 0; i < 64; ++i)
        for (std::size_t k = 0; k < 64; ++k)
            EXPECT_EQ(turned[k] >> i & 1, block[i] >> k & 1) << i << ' ' << k;
    transpose(turned);
    EXPECT_EQ(turned, block);
}

}  // namespace
}  // namespace endmill
