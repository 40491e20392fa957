// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/shown_numbers.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "endmill/core/text.h"

namespace endmill {
namespace {

// Smaller lengths in mm can neither be measured nor machined.
constexpr double negligible = 5e-7;
constexpr int most_shown_decimals = 6;
// Significant digits of measured quantities from 1 up, of smaller ones and of times, and
// of limits and results of formulas.
constexpr int digits = 4;
constexpr int digits_below_one = 3;
constexpr int exact_digits = 5;

// Number of decimals that leave `significant_digits` digits, at most six.
int decimals_of(double magnitude, int significant_digits)
{
    const int whole_digits = static_cast<int>(std::floor(std::log10(magnitude))) + 1;
    return std::min(std::max(significant_digits - whole_digits, 0), most_shown_decimals);
}

std::string without_trailing_zeros(std::string text)
{
    if (text.find('.') == std::string::npos)
        return text;
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.')
        text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string with_decimals(double value, int decimals)
{
    return without_trailing_zeros(fmt::format("{:.{}f}", value, decimals));
}

std::string rounded(double value, int significant_digits)
{
    if (!std::isfinite(value))
        return fmt::format("{}", value);
    const double magnitude = std::abs(value);
    if (magnitude < negligible)
        return "0";
    return with_decimals(value, decimals_of(magnitude, significant_digits));
}

int usual_digits(double value)
{
    return std::abs(value) < 1 ? digits_below_one : digits;
}

}  // namespace

std::string shown(double value)
{
    return rounded(value, usual_digits(value));
}

std::string shown_result(double value)
{
    return rounded(value, exact_digits);
}

std::string shown_time(double value)
{
    return rounded(value, digits_below_one);
}

std::string shown_coordinate(double mm)
{
    const std::string text = fmt::format("{:.3f}", mm);
    return text == "-0.000" ? "0.000" : text;
}

std::string shown_degrees(double degrees)
{
    return without_trailing_zeros(fmt::format("{:.2f}", degrees));
}

std::string shown_against(double value, double limit)
{
    constexpr int most_digits = 12;
    std::string text = shown(value);
    for (int more = usual_digits(value) + 1; more <= most_digits; ++more) {
        const double said = number_from_text(text).value_or(value);
        if ((said > limit) == (value > limit))
            break;
        text = rounded(value, more);
    }
    return text;
}

std::string shown_limit(double mm)
{
    if (!std::isfinite(mm))
        return shown_result(mm);
    if (mm < negligible)
        return fmt::format("{:.3g}", mm);
    // Rounding may make a computed limit slightly smaller than a round number.
    const double scale = std::pow(10, decimals_of(mm, exact_digits));
    return shown_result(std::floor(mm * (1 + limit_rounding) * scale) / scale);
}

std::string shown_bound(double mm)
{
    if (!std::isfinite(mm) || mm <= 0)
        return shown_result(mm);
    const int decimals =
        decimals_of(std::max(mm, std::pow(10, -most_shown_decimals)), exact_digits);
    const double scale = std::pow(10, decimals);
    return with_decimals(std::ceil(mm * (1 - limit_rounding) * scale) / scale, decimals);
}

}  // namespace endmill
