// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/text.h"

#include <array>
#include <bit>
#include <charconv>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <locale>
#include <random>

#include <gtest/gtest.h>

namespace endmill {
namespace {

using Limits = std::numeric_limits<double>;

TEST(Numbers, AnyFiniteDoubleReadsBackToTheSameBits)
{
    std::mt19937_64 random{1};
    int finite = 0;
    while (finite < 100000) {
        const double value = std::bit_cast<double>(random());
        if (!std::isfinite(value) || value == 0)
            continue;
        ++finite;
        const auto back = number_from_text(to_text(value));
        ASSERT_TRUE(back) << to_text(value);
        EXPECT_EQ(std::bit_cast<std::uint64_t>(*back),
                  std::bit_cast<std::uint64_t>(value));
    }
}

TEST(Numbers, ExtremesReadBackToTheSameBits)
{
    for (const double value :
         {Limits::min(), Limits::max(), Limits::denorm_min(), Limits::lowest(),
          std::nextafter(Limits::min(), 0), Limits::epsilon(), 0x1p-1074})
        EXPECT_EQ(number_from_text(to_text(value)), value);
}

TEST(Numbers, AreReadAsTheStandardLibraryReadsThem)
{
    std::mt19937 random{2};
    for (int k = 0; k < 20000; ++k) {
        std::string text = random() % 2 == 0 ? "-" : "";
        for (unsigned digit = 0; digit <= random() % 25; ++digit)
            text += char('0' + random() % 10);
        text += '.';
        for (unsigned digit = 0; digit <= random() % 25; ++digit)
            text += char('0' + random() % 10);
        text += "e" + std::to_string(int(random() % 600) - 300);
        const double expected = std::strtod(text.c_str(), nullptr);
        if (expected != 0 && std::isfinite(expected)) {
            EXPECT_EQ(number_from_text(text), expected) << text;
        }
    }
}

// With one digit less, the text would read back to another double.
TEST(Numbers, TextIsTheShortest)
{
    EXPECT_EQ(to_text(0.1), "0.1");
    EXPECT_EQ(to_text(120), "120");
    EXPECT_EQ(to_text(-2.5), "-2.5");
    EXPECT_EQ(to_text(1.0 / 3), "0.3333333333333333");
    EXPECT_EQ(to_text(1e300), "1e+300");
    std::mt19937 random{3};
    for (int k = 0; k < 1000; ++k) {
        const double value = (random() % 1000000) / 1000.0;
        EXPECT_LE(to_text(value).size(), 7U) << to_text(value);
    }
}

// Decimals of few digits have a conversion of their own, which must give the same text as
// the standard library. Their neighbours have no short text.
TEST(Numbers, OfFewDecimalsHaveTheTextOfTheStandardLibrary)
{
    std::mt19937_64 random{7};
    const auto check = [](double value) {
        std::array<char, 40> buffer;
        const auto end =
            std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
        ASSERT_EQ(to_text(value), std::string(buffer.data(), end.ptr));
    };
    for (int k = 0; k < 300'000; ++k) {
        const double scale = std::pow(10, static_cast<int>(random() % 13));
        const auto units = static_cast<std::int64_t>(random() >> (random() % 60)) %
                           1'000'000'000'000'000;
        const double value =
            (k % 2 == 0 ? 1 : -1) * (static_cast<double>(units) + 1) / scale;
        check(value);
        check(std::nextafter(value, 0));
        check(std::nextafter(value, 2 * value));
    }
    for (const double bound :
         {0.001, 0.01, 0.05, 0.1, 1.0, 9999.0, 10'000.0, 99'999.5, 1e5, 1e6, 123'456.789})
        for (const double value :
             {bound, std::nextafter(bound, 0), std::nextafter(bound, 1e9)}) {
            check(value);
            check(-value);
        }
}

TEST(Numbers, MinusZeroIsWrittenWithoutItsSign)
{
    EXPECT_EQ(to_text(-0.0), "0");
    EXPECT_EQ(to_text(0.0), "0");
    EXPECT_EQ(number_from_text("-0"), 0.0);
}

TEST(Numbers, AppendingIsTheSameText)
{
    std::string text = "x=";
    append_text(text, -1.5);
    append_text(text, 2e-7);
    EXPECT_EQ(text, "x=" + to_text(-1.5) + to_text(2e-7));
}

TEST(Numbers, AreReadInEveryUsualSpelling)
{
    for (const char* text :
         {"5", "+5", "5.", "5.0", "0.5e1", "5e0", "50E-1", "005", "+.5e+1"})
        EXPECT_EQ(number_from_text(text), 5.0) << text;
    EXPECT_EQ(number_from_text("-.5"), -0.5);
    EXPECT_EQ(number_from_text(std::string(400, '0') + "7"), 7.0);
}

TEST(Numbers, OtherThanDecimalAreNotRead)
{
    for (const char* text :
         {"",          " ",     "+",    "-",     ".",       "e5",   "1e",
          "1e+",       "+-5",   "-+5",  "++5",   "--5",     "5 ",   " 5",
          "5\n",       "5mm",   "1,5",  "1.5.",  "1 000",   "0x10", "0x1p3",
          "1p3",       "nan",   "NaN",  "-nan",  "nan(1)",  "inf",  "+inf",
          "-Infinity", "1_000", "five", "5e5.5", "\xC2\xBD"})
        EXPECT_FALSE(number_from_text(text)) << '"' << text << '"';
    EXPECT_FALSE(number_from_text(std::string_view{"5\0", 2})) << "a zero byte";
}

TEST(Numbers, ThatOverflowOrUnderflowToZeroAreNotRead)
{
    for (const char* text : {"1e309", "-1e309", "1.8e308", "1e-400", "-1e-400",
                             "1e999999999", "1e-999999999", "1e99999999999999999999"})
        EXPECT_FALSE(number_from_text(text)) << text;
    EXPECT_EQ(number_from_text("0e999999999"), 0.0);
    EXPECT_EQ(number_from_text("1e-320"), 1e-320) << "small, but not zero";
}

TEST(Numbers, ReadOnlyTheViewThatTheyAreGiven)
{
    const std::string_view row{"12.5,7"};
    EXPECT_EQ(number_from_text(row.substr(0, 4)), 12.5);
    EXPECT_EQ(number_from_text(row.substr(0, 3)), 12.0);
}

// A locale with a decimal comma and grouped thousands.
class Comma : public std::numpunct<char> {
protected:
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST(Numbers, DoNotDependOnTheLocale)
{
    const std::locale before = std::locale::global(std::locale{std::locale{}, new Comma});
    for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE", ""})
        std::setlocale(LC_ALL, name);  // if this machine has the locale
    EXPECT_EQ(to_text(1234567.5), "1234567.5");
    EXPECT_EQ(number_from_text("1234567.5"), 1234567.5);
    EXPECT_FALSE(number_from_text("1,5"));
    std::locale::global(before);
    std::setlocale(LC_ALL, "C");
}

TEST(Numbers, CountThingsInTheSingularOrThePlural)
{
    EXPECT_EQ(counted(0, "point"), "0 points");
    EXPECT_EQ(counted(1, "point"), "1 point");
    EXPECT_EQ(counted(12, "point"), "12 points");
}

}  // namespace
}  // namespace endmill
