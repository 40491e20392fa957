// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/centred_form.h"

#include <random>

#include <gtest/gtest.h>

namespace endmill {
namespace {

CentredForm variable(std::size_t number, double middle, double half)
{
    CentredForm form{middle, {middle - half, middle + half}, {}};
    form.slopes[number] = {half, half};
    return form;
}

// A function of all operations, for forms and for numbers.
template <typename Number, typename Root>
Number function(const Number& x, const Number& y, const Number& z, const Root& root)
{
    return root(x * x + 2.0 * y) * z - x * y;
}

TEST(CentredForm, ContainsAFunctionAtRandomPlaces)
{
    constexpr double half = 0.1;
    const CentredForm x = variable(0, 1.2, half);
    const CentredForm y = variable(1, 0.7, half);
    const CentredForm z = variable(2, -0.5, half);
    const CentredForm f = function(x, y, reciprocal(z),
                                   [](const CentredForm& a) { return square_root(a); });
    EXPECT_NEAR(f.middle, std::sqrt(1.2 * 1.2 + 1.4) / -0.5 - 1.2 * 0.7, 1e-14);
    std::mt19937_64 engine{1};
    std::uniform_real_distribution<double> uniform{-half, half};
    for (int k = 0; k < 1000; ++k) {
        const double value =
            function(1.2 + uniform(engine), 0.7 + uniform(engine),
                     1 / (-0.5 + uniform(engine)), [](double a) { return std::sqrt(a); });
        EXPECT_TRUE(contains(f.range, value));
    }
}

// The range of x - x is 0 by the mean value theorem.
TEST(CentredForm, KnowsThatVariablesCancel)
{
    const CentredForm x = variable(0, 3, 1);
    const CentredForm zero = x - x;
    EXPECT_EQ(zero.range.low, 0);
    EXPECT_EQ(zero.range.high, 0);
    EXPECT_EQ((x + CentredForm::constant(2)).range.high, 6);
}

TEST(CentredForm, ThePartBelowZeroHasTheSlopesOfBothSides)
{
    const CentredForm part = negative_part(variable(0, 0.2, 1));
    EXPECT_EQ(part.middle, 0);
    EXPECT_EQ(part.range.high, 0);
    EXPECT_NEAR(part.range.low, -0.8, 1e-15);
    EXPECT_EQ(part.slopes[0].low, 0);
    EXPECT_EQ(part.slopes[0].high, 1);
    EXPECT_EQ(negative_part(variable(0, 2, 1)).range.high, 0);
    EXPECT_EQ(negative_part(variable(0, -2, 1)).range.high, -1);
}

}  // namespace
}  // namespace endmill
