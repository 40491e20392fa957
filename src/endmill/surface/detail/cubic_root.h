// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

namespace endmill {

/// First t in [0, 1] at which a cubic that starts below zero reaches zero, be it only by
/// touching. Found by splitting [0, 1] at the extrema of the cubic, so that two close
/// roots are not missed, then by Newton's method kept in its bracket.
///
/// \param bernstein the four Bernstein coefficients, any unit; the first is below zero.
/// \return t with |cubic(t)| below a few roundings of the largest coefficient;
///         nothing if the cubic stays below zero on all of [0, 1].
std::optional<double> first_rise_to_zero(const std::array<double, 4>& bernstein);

/// Bernstein coefficients on [from, 1] of the cubic that has `bernstein` on [0, 1].
std::array<double, 4> restrict_to_upper_end(const std::array<double, 4>& bernstein,
                                            double from);

}  // namespace endmill
