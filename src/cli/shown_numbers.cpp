// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/shown_numbers.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace endmill {
namespace {

// Smaller lengths in mm can neither be measured nor machined.
constexpr double negligible = 5e-7;
constexpr int significant_digits = 5;

// Number of decimals that leave `significant_digits` digits, at most six.
int decimals_of(double magnitude)
{
    constexpr int most_decimals = 6;
    const int whole_digits = static_cast<int>(std::floor(std::log10(magnitude))) + 1;
    return std::min(std::max(significant_digits - whole_digits, 0), most_decimals);
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

}  // namespace

std::string shown(double value)
{
    if (!std::isfinite(value))
        return fmt::format("{}", value);
    const double magnitude = std::abs(value);
    if (magnitude < negligible)
        return "0";
    return without_trailing_zeros(fmt::format("{:.{}f}", value, decimals_of(magnitude)));
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

std::string shown_limit(double mm)
{
    // Rounding may make a computed limit slightly smaller than a round number.
    const double scale = std::pow(10, decimals_of(mm));
    return shown(std::floor(mm * (1 + limit_rounding) * scale) / scale);
}

}  // namespace endmill
