// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/interval_forms.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/planning/path_interval.h"

namespace endmill {
namespace {

// path_interval uses a rearranged formula without cancellation.
TEST(IntervalForms, InFiftyDigitsAreThePathInterval)
{
    for (const double rho : {20.0, 100.0, 1e4, 1e6})
        for (const double h : {0.001, 0.1, 1.0}) {
            const double exact = interval_in_50_digits({5, h, rho});
            const double chord = path_interval(BallCutter{5}, 1 / rho, h).chord;
            EXPECT_NEAR(exact / chord, 1, 4e-15) << rho << " " << h;
        }
}

// R = 4, h = 1 and a section that is nearly a plane: 2 sqrt(2 R h - h^2) = 2 sqrt(7).
TEST(IntervalForms, TendToThePlane)
{
    EXPECT_NEAR(interval_in_50_digits({4, 1, 1e12}), 2 * std::sqrt(7), 1e-10);
}

TEST(IntervalForms, AgreeWhereNothingCancels)
{
    const IntervalCase mild{5, 1, 10};
    const double exact = interval_in_50_digits(mild);
    for (const IntervalForm form : {IntervalForm::Printed, IntervalForm::Squares,
                                    IntervalForm::Factors, IntervalForm::Expanded}) {
        EXPECT_NEAR(printed_interval(mild, form, Precision::Double) / exact, 1, 1e-13);
        EXPECT_NEAR(printed_interval(mild, form, Precision::Single) / exact, 1, 1e-4);
    }
}

TEST(IntervalForms, OfThePrintLoseAllDigitsInSinglePrecision)
{
    const IntervalCase flat{5, 0.001, 1e5};
    const double exact = interval_in_50_digits(flat);
    const double single =
        printed_interval(flat, IntervalForm::Printed, Precision::Single);
    EXPECT_FALSE(std::abs(single / exact - 1) < 0.1);
    EXPECT_NEAR(printed_interval(flat, IntervalForm::Expanded, Precision::Single) / exact,
                1, 1e-5);
}

}  // namespace
}  // namespace endmill
