// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

namespace endmill {

/// A polynomial on [0, 1], given by its Bernstein coefficients. They bound it; the first
/// and the last one are its values at the ends.
using BernsteinPolynomial = std::vector<double>;

/// The coefficients on [from, to] of the polynomial with the given coefficients on [0,
/// 1].
/// \pre 0 <= from < to <= 1
BernsteinPolynomial restricted(BernsteinPolynomial polynomial, double from, double to);

/// The first t in [0, 1] at which a polynomial that starts below zero reaches zero, even
/// if it only touches zero. The interval is halved until the signs of the coefficients
/// allow a single root, which is found by Newton's method within its bracket. A cubic is
/// solved by `cubic_root.h`.
/// \pre there are at least two coefficients, all of one unit.
/// \return t with an error of at most 2^-50, or at which the polynomial is within a few
///         roundings of its largest coefficient from zero; nothing if the polynomial
///         stays below zero on [0, 1].
std::optional<double> first_rise_to_zero(const BernsteinPolynomial& polynomial);

}  // namespace endmill
