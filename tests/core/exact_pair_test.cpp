// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/detail/exact_pair.h"

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

TEST(ExactPair, HoldsSumsAndProductsAsFractionsDo)
{
    std::mt19937 random{3};
    for (int k = 0; k < 2000; ++k) {
        const double a = mixed(random);
        const double b = mixed(random);
        const ExactPair sum = exact_sum(a, b);
        EXPECT_EQ(Exact{sum.rounded} + Exact{sum.rest}, Exact{a} + Exact{b});
        EXPECT_EQ(sum.rounded, a + b);
        const ExactPair product = exact_product(a, b);
        EXPECT_EQ(Exact{product.rounded} + Exact{product.rest}, Exact{a} * Exact{b});
        EXPECT_EQ(product.rounded, a * b);
    }
}

TEST(ExactPair, TakesAnOrderedSumSooner)
{
    for (const auto& [a, b] : {std::pair{1.0, 0x1p-60}, {-3.0, 1.0 / 3}, {0.0, 5.0}}) {
        const ExactPair ordered = exact_ordered_sum(a, b);
        const ExactPair any = exact_sum(a, b);
        EXPECT_EQ(ordered.rounded, any.rounded);
        EXPECT_EQ(ordered.rest, any.rest);
    }
}

}  // namespace
}  // namespace endmill
