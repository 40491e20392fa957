// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace endmill {

/// Appends `value` with `decimals` digits after the point, correctly rounded, without an
/// exponent and never as "-0".
/// \param text to which the number is appended.
/// \param value the number.
/// \param decimals digits after the point, 0 to `most_decimals`.
/// \return the number as written: the double nearest to the text.
/// \throws DomainError unless `value` is finite and `decimals` is in its range.
double append_fixed(std::string& text, double value, int decimals);

/// Appends `value` as `append_fixed`, without zeros at the end of the fraction: "800",
/// "0.25".
double append_trimmed(std::string& text, double value, int decimals);

/// Appends `value` rounded towards zero to so many significant digits, without zeros at the
/// end of the fraction and with at most `most_decimals` decimals.
/// \return the number as written: at most `value`, except for the last bit of a double.
/// \throws DomainError unless `value` is finite and at least 0.
double append_rounded_down(std::string& text, double value, int significant_digits);

/// Appends the shortest plain decimal that reads back to the same double.
/// \throws DomainError unless `value` is finite.
void append_exact(std::string& text, double value);

/// The double that the whole of `text` states as a plain decimal: "-1.5", ".5", "5.",
/// "+2".
/// \return std::nullopt for anything else: an exponent, infinity, NaN, or an overflow.
std::optional<double> plain_number(std::string_view text);

}  // namespace endmill
