// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/detail/widest_registers.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

using Numbers = std::array<double, 64>;

inline void compute(const Numbers& a, const Numbers& b, Numbers& out)
{
    for (std::size_t k = 0; k < a.size(); ++k)
        out[k] = std::sqrt(std::abs(a[k] * b[k] - a[k])) / (b[k] + 3) - a[k];
}

ENDMILL_WIDEST_REGISTERS
void compute_widely(const Numbers& a, const Numbers& b, Numbers& out)
{
    compute(a, b, out);
}

TEST(WidestRegisters, GiveTheSameBits)
{
    test::Random random{8};
    for (int n = 0; n < 100; ++n) {
        Numbers a;
        Numbers b;
        for (std::size_t k = 0; k < a.size(); ++k) {
            a[k] = random.uniform(-1, 1);
            b[k] = random.uniform(-1, 1);
        }
        Numbers narrow;
        Numbers wide;
        compute(a, b, narrow);
        compute_widely(a, b, wide);
        EXPECT_EQ(narrow, wide);
    }
}

}  // namespace
}  // namespace endmill
