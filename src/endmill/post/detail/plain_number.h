// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace endmill {

/// Digits after the point that a machine program may have. Nine keep what a double knows
/// of a coordinate up to 1e6 mm.
inline constexpr int most_decimals = 9;

/// Appends `value` with so many digits after the point, correctly rounded: without an
/// exponent, never "-0".
/// \return the number that was written: the double nearest to the text.
/// \throws DomainError unless `value` is finite and 0 <= `decimals` <= `most_decimals`.
double append_fixed(std::string& text, double value, int decimals);

/// The same without zeros at the end of the fraction: "800", "0.25".
double append_trimmed(std::string& text, double value, int decimals);

/// Appends the shortest decimals that read back to the same double, without an exponent.
/// \throws DomainError unless `value` is finite.
void append_exact(std::string& text, double value);

/// The double that the whole of `text` spells in plain decimals: "-1.5", ".5", "5.", "+2".
/// \return nothing for anything else: an exponent, infinity, NaN, or what overflows.
std::optional<double> plain_number(std::string_view text);

}  // namespace endmill
