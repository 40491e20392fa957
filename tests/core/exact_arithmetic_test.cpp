// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/detail/exact_arithmetic.h"

#include <random>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_int.hpp>

namespace endmill {
namespace {

using Exact = boost::multiprecision::cpp_rational;

double mixed(std::mt19937& random)
{
    std::uniform_real_distribution<double> share{-1, 1};
    std::uniform_int_distribution<int> exponent{-60, 60};
    return std::ldexp(share(random), exponent(random));
}

TEST(ExactPair, EqualsTheSumAndProductInFractions)
{
    std::mt19937 random{3};
    for (int k = 0; k < 2000; ++k) {
        const double a = mixed(random);
        const double b = mixed(random);
        const ExactPair sum = two_sum(a, b);
        EXPECT_EQ(Exact{sum.rounded} + Exact{sum.rest}, Exact{a} + Exact{b});
        EXPECT_EQ(sum.rounded, a + b);
        const ExactPair product = two_product(a, b);
        EXPECT_EQ(Exact{product.rounded} + Exact{product.rest}, Exact{a} * Exact{b});
        EXPECT_EQ(product.rounded, a * b);
    }
}

TEST(ExactPair, OfOrderedTermsIsTheSameByFewerOperations)
{
    for (const auto& [a, b] : {std::pair{1.0, 0x1p-60}, {-3.0, 1.0 / 3}, {0.0, 5.0}}) {
        const ExactPair ordered = fast_two_sum(a, b);
        const ExactPair any = two_sum(a, b);
        EXPECT_EQ(ordered.rounded, any.rounded);
        EXPECT_EQ(ordered.rest, any.rest);
    }
}

// The exact sign of random sums whose terms nearly cancel.
TEST(ExactSum, HasTheSignOfTheSumInFractions)
{
    std::mt19937 random{5};
    for (int k = 0; k < 2000; ++k) {
        ExactSum sum;
        Exact expected{0};
        for (int term = 0; term < 5; ++term) {
            const double a = mixed(random);
            const double b = mixed(random);
            sum.add_product(a, b);
            expected += Exact{a} * Exact{b};
            sum.add(-a * b);
            expected -= Exact{a * b};
        }
        EXPECT_EQ(sum.sign(), expected.sign());
    }
}

TEST(ExactSum, IsZeroWhereAllTermsCancel)
{
    ExactSum sum;
    EXPECT_EQ(sum.sign(), 0);
    for (const double term : {1e100, 0.1, -1e100, 1e-300, -0.1})
        sum.add(term);
    EXPECT_EQ(sum.sign(), 1);
    sum.add(-1e-300);
    EXPECT_EQ(sum.sign(), 0);
}

}  // namespace
}  // namespace endmill
