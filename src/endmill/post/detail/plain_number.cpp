// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/plain_number.h"

#include <array>
#include <charconv>
#include <cmath>

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

// The double nearest to a plain decimal.
double value_of(std::string_view number)
{
    double value = 0;
    std::from_chars(number.data(), number.data() + number.size(), value,
                    std::chars_format::fixed);
    return value;
}

using Digits = std::array<char, longest_number>;

// Writes `value` into `digits`, correctly rounded.
std::string_view fixed(Digits& digits, double value, int decimals)
{
    require(std::isfinite(value), "plain number: a number must be finite");
    require(0 <= decimals && decimals <= most_decimals,
            "plain number: need 0 to 9 decimals");
    const auto written = std::to_chars(digits.data(), digits.data() + digits.size(),
                                       value, std::chars_format::fixed, decimals);
    return without_minus_zero({digits.data(), written.ptr});
}

}  // namespace

double append_fixed(std::string& text, double value, int decimals)
{
    Digits digits;
    const std::string_view number = fixed(digits, value, decimals);
    text += number;
    return value_of(number);
}

double append_trimmed(std::string& text, double value, int decimals)
{
    Digits digits;
    std::string_view number = fixed(digits, value, decimals);
    if (decimals > 0) {
        number = number.substr(0, number.find_last_not_of('0') + 1);
        if (number.ends_with('.'))
            number.remove_suffix(1);
    }
    text += number;
    return value_of(number);
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
