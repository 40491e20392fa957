// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

namespace endmill {

/// A polynomial on [0, 1] by its Bernstein coefficients, which bound it; the first and
/// the last are its values at the ends.
using BernsteinPolynomial = std::vector<double>;

/// Coefficients on [from, to] of the polynomial that has `polynomial` on [0, 1].
/// \pre 0 <= from < to <= 1
BernsteinPolynomial restricted(BernsteinPolynomial polynomial, double from, double to);

/// First t in [0, 1] at which a polynomial that starts below zero reaches zero, be it
/// only by touching. Found by halving until the signs of the coefficients allow one root
/// only, then by Newton's method kept in its bracket; a cubic by `cubic_root.h`.
/// \pre at least two coefficients, of any one unit.
/// \return t to 2^-50, or with the polynomial below a few roundings of its largest
///         coefficient; nothing if it stays below zero on all of [0, 1].
std::optional<double> first_rise_to_zero(const BernsteinPolynomial& polynomial);

}  // namespace endmill
