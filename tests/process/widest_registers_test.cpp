// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/widest_registers.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

using Numbers = std::array<double, 64>;

inline Numbers shares(const Numbers& x, const Numbers& y)
{
    Numbers out;
    for (std::size_t k = 0; k < x.size(); ++k)
        out[k] = x[k] / std::sqrt(x[k] * x[k] + y[k] * y[k]) - y[k] * x[k];
    return out;
}

ENDMILL_PROCESS_WIDEST
void shares_widely(const Numbers& x, const Numbers& y, Numbers& out)
{
    out = shares(x, y);
}

TEST(ProcessWidest, GivesTheSameBits)
{
    test::Random random{8};
    for (int n = 0; n < 100; ++n) {
        Numbers x;
        Numbers y;
        for (std::size_t k = 0; k < x.size(); ++k) {
            x[k] = random.uniform(-1, 1);
            y[k] = random.uniform(-1, 1);
        }
        Numbers wide;
        shares_widely(x, y, wide);
        EXPECT_EQ(shares(x, y), wide);
    }
}

}  // namespace
}  // namespace endmill
