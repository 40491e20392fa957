// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/plain_number.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>

#include "endmill/core/error.h"
#include "endmill/post/program.h"

namespace endmill {
namespace {

// Bytes. The largest double has 309 digits before the point, the smallest 1074 after it.
constexpr std::size_t longest_number = 1100;

// `number` without its sign if all its digits are 0.
std::string_view without_minus_zero(std::string_view number)
{
    const bool is_zero = number.find_first_of("123456789") == std::string_view::npos;
    if (is_zero && number.starts_with('-'))
        number.remove_prefix(1);
    return number;
}

// Powers of ten by their exponents, up to `most_decimals`. All are exact.
constexpr std::array<double, 10> powers_of_ten{1,   1e1, 1e2, 1e3, 1e4,
                                               1e5, 1e6, 1e7, 1e8, 1e9};

// Bounds within which a number is rounded by a product with a power of ten. Below the first
// one the product has an error of at most 1e-5, so beyond the second one from the middle
// between two whole numbers it is rounded as the exact product is.
constexpr double most_units = 1e11;  // exclusive
constexpr double near_middle = 1e-4;

// |value| in units of the last decimal, correctly rounded; nothing where the product cannot
// decide. This takes a fraction of the time of the general case.
std::optional<std::uint64_t> rounded_units(double value, int decimals)
{
    const double exact =
        std::abs(value) * powers_of_ten[static_cast<std::size_t>(decimals)];
    if (!(exact < most_units))
        return std::nullopt;
    const auto whole = static_cast<std::uint64_t>(exact);
    const double rest = exact - static_cast<double>(whole);
    if (std::abs(rest - 0.5) < near_middle)
        return std::nullopt;
    return whole + (rest > 0.5 ? 1 : 0);
}

// Writes `units` of the last decimal from `begin` on. Returns the end.
char* write_units(char* begin, std::uint64_t units, int decimals)
{
    const auto unit =
        static_cast<std::uint64_t>(powers_of_ten[static_cast<std::size_t>(decimals)]);
    constexpr std::size_t most_digits = 20;
    char* end = std::to_chars(begin, begin + most_digits, units / unit).ptr;
    if (decimals == 0)
        return end;
    *end++ = '.';
    std::uint64_t fraction = units % unit;
    for (int k = decimals; k-- > 0; fraction /= 10)
        end[k] = static_cast<char>('0' + fraction % 10);
    return end + decimals;
}

// The double nearest to a plain decimal.
double value_of(std::string_view number)
{
    double value = 0;
    std::from_chars(number.data(), number.data() + number.size(), value,
                    std::chars_format::fixed);
    return value;
}

using Digits = std::array<char, longest_number>;

// A number as written.
struct Written {
    std::string_view text;  // in the digits
    double value;           // that of the text
};

// Writes `value` into `digits`, correctly rounded.
Written fixed(Digits& digits, double value, int decimals)
{
    require(std::isfinite(value), "plain number: a number must be finite");
    require(0 <= decimals && decimals <= most_decimals,
            "plain number: need 0 to 9 decimals");
    if (const auto units = rounded_units(value, decimals)) {
        const bool is_negative = value < 0 && *units > 0;
        digits[0] = '-';
        char* const begin = digits.data() + (is_negative ? 1 : 0);
        const char* const end = write_units(begin, *units, decimals);
        // Both numbers are exact, so that the quotient is the nearest double.
        const double size = static_cast<double>(*units) /
                            powers_of_ten[static_cast<std::size_t>(decimals)];
        return {{digits.data(), end}, is_negative ? -size : size};
    }
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                   std::chars_format::fixed, decimals)
                         .ptr;
    const std::string_view text = without_minus_zero({digits.data(), end});
    return {text, value_of(text)};
}

}  // namespace

double append_fixed(std::string& text, double value, int decimals)
{
    Digits digits;
    const Written written = fixed(digits, value, decimals);
    text += written.text;
    return written.value;
}

double append_trimmed(std::string& text, double value, int decimals)
{
    Digits digits;
    const Written written = fixed(digits, value, decimals);
    std::string_view number = written.text;
    if (decimals > 0) {
        number = number.substr(0, number.find_last_not_of('0') + 1);
        if (number.ends_with('.'))
            number.remove_suffix(1);
    }
    text += number;
    return written.value;
}

double append_rounded_down(std::string& text, double value, int significant_digits)
{
    require(std::isfinite(value) && value >= 0,
            "append_rounded_down: need a number from 0");
    if (value == 0)
        return append_trimmed(text, 0, 0);
    const int exponent = static_cast<int>(std::floor(std::log10(value)));
    const int decimals = std::min(significant_digits - 1 - exponent, most_decimals);
    const double scale = std::pow(10.0, std::abs(decimals));
    if (decimals >= 0)
        return append_trimmed(text, std::floor(value * scale) / scale, decimals);
    return append_trimmed(text, std::floor(value / scale) * scale, 0);
}

void append_exact(std::string& text, double value)
{
    require(std::isfinite(value), "plain number: a number must be finite");
    Digits digits;
    const auto written = std::to_chars(digits.data(), digits.data() + digits.size(),
                                       value, std::chars_format::fixed);
    text += without_minus_zero({digits.data(), written.ptr});
}

std::optional<double> plain_number(std::string_view text)
{
    if (text.starts_with('+') && !text.starts_with("+-"))
        text.remove_prefix(1);
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value, std::chars_format::fixed);
    if (read.ec != std::errc{} || read.ptr != end || !std::isfinite(value))
        return std::nullopt;
    return value;
}

}  // namespace endmill
