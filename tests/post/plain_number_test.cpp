// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/plain_number.h"

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/post/program.h"
#include "random.h"

namespace endmill {
namespace {

std::string fixed(double value, int decimals)
{
    std::string text;
    append_fixed(text, value, decimals);
    return text;
}

std::string trimmed(double value, int decimals)
{
    std::string text;
    append_trimmed(text, value, decimals);
    return text;
}

std::string exact(double value)
{
    std::string text;
    append_exact(text, value);
    return text;
}

TEST(PlainNumber, HasTheRequestedNumberOfDigits)
{
    EXPECT_EQ(fixed(1.5, 4), "1.5000");
    EXPECT_EQ(fixed(-12.34567, 3), "-12.346");
    EXPECT_EQ(fixed(7, 0), "7");
    EXPECT_EQ(fixed(1e22, 1), "10000000000000000000000.0");
    EXPECT_EQ(fixed(1e-7, 4), "0.0000");
}

TEST(PlainNumber, HasNoMinusZero)
{
    EXPECT_EQ(fixed(-0.0, 4), "0.0000");
    EXPECT_EQ(fixed(-0.00004, 4), "0.0000");
    EXPECT_EQ(fixed(-0.4, 0), "0");
    EXPECT_EQ(trimmed(-0.00004, 4), "0");
    EXPECT_EQ(exact(-0.0), "0");
    EXPECT_EQ(fixed(-0.00006, 4), "-0.0001");
}

TEST(PlainNumber, TrimmedHasNoZerosAtItsEnd)
{
    EXPECT_EQ(trimmed(800, 4), "800");
    EXPECT_EQ(trimmed(800, 0), "800");
    EXPECT_EQ(trimmed(0.25, 4), "0.25");
    EXPECT_EQ(trimmed(1.00001, 4), "1");
    EXPECT_EQ(trimmed(0, 4), "0");
}

// The C library rounds by an independent algorithm.
TEST(PlainNumber, RoundsAsTheCLibraryDoes)
{
    test::Random random{3};
    for (int k = 0; k < 20000; ++k) {
        const double value =
            random.log_uniform(1e-6, 1e6) * (random.uniform(-1, 1) < 0 ? -1 : 1);
        const int decimals = k % 10;
        char expected[64];
        std::snprintf(expected, sizeof expected, "%.*f", decimals, value);
        std::string text = "before ";
        const double written = append_fixed(text, value, decimals);
        if (std::atof(expected) != 0) {
            EXPECT_EQ(text, std::string{"before "} + expected);
        }
        EXPECT_EQ(written, std::atof(expected));
        // Half a unit of the last digit, plus half a unit of the written double.
        EXPECT_LE(std::abs(written - value),
                  0.5 * std::pow(10, -decimals) + 1.2e-16 * std::abs(value));
    }
}

// Near the middle between two decimals the product with a power of ten is not exact enough.
TEST(PlainNumber, RoundsAsTheCLibraryDoesNearTheMiddleBetweenTwoDecimals)
{
    test::Random random{4};
    for (int k = 0; k < 20000; ++k) {
        const int decimals = k % 10;
        const double unit = std::pow(10, -decimals);
        const double whole = std::floor(random.log_uniform(1, 1e13));
        double value = (whole + (k % 3 == 0 ? 0.5 : k % 3 == 1 ? 0.4999 : 0.5001)) * unit;
        for (int step = static_cast<int>(random.uniform(-3, 3)); step != 0;
             step += step < 0 ? 1 : -1)
            value = std::nextafter(value, step < 0 ? 0 : 1e300);
        char expected[64];
        std::snprintf(expected, sizeof expected, "%.*f", decimals, value);
        std::string text;
        EXPECT_EQ(append_fixed(text, value, decimals), std::atof(expected));
        EXPECT_EQ(text, expected);
    }
}

TEST(PlainNumber, ExactReadsBackToTheSameBitsWithoutExponent)
{
    std::mt19937_64 random{1};
    for (int k = 0; k < 20000; ++k) {
        const double value = std::bit_cast<double>(random());
        if (!std::isfinite(value) || value == 0)
            continue;
        const std::string text = exact(value);
        EXPECT_EQ(text.find_first_not_of("-.0123456789"), std::string::npos) << text;
        EXPECT_EQ(std::strtod(text.c_str(), nullptr), value);
        EXPECT_EQ(plain_number(text), value);
    }
    for (const double value : {std::numeric_limits<double>::max(),
                               std::numeric_limits<double>::denorm_min(), 7.5, 1e-5})
        EXPECT_EQ(plain_number(exact(value)), value);
}

TEST(PlainNumber, IsReadInAllItsPlainForms)
{
    EXPECT_EQ(plain_number("-1.5"), -1.5);
    EXPECT_EQ(plain_number(".5"), 0.5);
    EXPECT_EQ(plain_number("5."), 5);
    EXPECT_EQ(plain_number("+2"), 2);
    EXPECT_EQ(plain_number("007"), 7);
}

TEST(PlainNumber, RefusesOtherTexts)
{
    for (const char* text : {"", "-", "+", ".", "1e5", "1E5", "1,5", "nan", "inf", "-inf",
                             "+-1", "--1", "0x10", "1 ", " 1", "1.2.3", "[1]", "#1"})
        EXPECT_FALSE(plain_number(text)) << text;
    EXPECT_FALSE(plain_number(std::string(400, '9')));
}

TEST(PlainNumber, RefusesToWriteNonFiniteNumbersAndTooManyDigits)
{
    const double not_a_number = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(fixed(not_a_number, 4), DomainError);
    EXPECT_THROW(trimmed(std::numeric_limits<double>::infinity(), 4), DomainError);
    EXPECT_THROW(exact(not_a_number), DomainError);
    EXPECT_THROW(fixed(1, -1), DomainError);
    EXPECT_THROW(fixed(1, most_decimals + 1), DomainError);
}

}  // namespace
}  // namespace endmill
