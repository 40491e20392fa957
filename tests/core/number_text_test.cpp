// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/detail/number_text.h"

#include <array>
#include <charconv>
#include <limits>
#include <string_view>

#include <gtest/gtest.h>

namespace endmill {
namespace {

// The text reads back to the same number, stays within its bytes and is that of to_chars
// where that has no exponent.
TEST(WriteNumber, WritesTheShortestText)
{
    using Limits = std::numeric_limits<double>;
    for (const double value :
         {0.0, 1.0, -1.5, 0.1, 1.0 / 3, -2e-308, 123456.789, 999999.999999999, 1e22,
          Limits::max(), Limits::lowest(), Limits::min(), Limits::denorm_min()}) {
        std::array<char, longest_number_text> text;
        const char* const end = write_number(text.data(), value);
        ASSERT_LE(end, text.data() + text.size());
        double read = 0;
        EXPECT_EQ(std::from_chars(text.data(), end, read).ptr, end);
        EXPECT_EQ(read, value);
        std::array<char, longest_number_text> shortest;
        const auto to =
            std::to_chars(shortest.data(), shortest.data() + shortest.size(), value);
        EXPECT_EQ(std::string_view(text.data(), end),
                  std::string_view(shortest.data(), to.ptr));
    }
}

}  // namespace
}  // namespace endmill
