// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

namespace endmill {

/// The first t in [0, 1] at which a cubic that starts below zero reaches zero, even if it
/// only touches zero. The interval is divided at the extrema of the cubic, so that two
/// close roots are not missed. The root of a monotone piece is found by Newton's method
/// within its bracket.
///
/// \param bernstein the four Bernstein coefficients, in any unit; the first one is below
///         zero.
/// \return t at which |cubic(t)| is within a few roundings of the largest coefficient;
///         nothing if the cubic stays below zero on [0, 1].
std::optional<double> first_rise_to_zero(const std::array<double, 4>& bernstein);

/// The Bernstein coefficients on [from, 1] of the cubic with the given coefficients on
/// [0, 1].
std::array<double, 4> restrict_to_upper_end(const std::array<double, 4>& bernstein,
                                            double from);

}  // namespace endmill
