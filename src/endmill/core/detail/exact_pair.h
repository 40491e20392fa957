// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace endmill {

/// A rounded sum or product of two doubles and what the rounding lost: together exact, but
/// where the rest would be below the smallest double.
struct ExactPair {
    double rounded;  ///< to nearest
    double rest;     ///< at most half a unit in the last place of `rounded`
};

/// a + b. \pre it does not overflow.
/// Source: Knuth, The Art of Computer Programming 2, 4.2.2, theorem B.
inline ExactPair exact_sum(double a, double b)
{
    const double sum = a + b;
    const double b_part = sum - a;
    return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// The same for |a| >= |b|, or a = 0.
/// Source: Dekker, A floating-point technique for extending the available precision, 1971.
inline ExactPair exact_ordered_sum(double a, double b)
{
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

/// a b. \pre it does not overflow; exact unless its rest underflows.
inline ExactPair exact_product(double a, double b)
{
    const double product = a * b;
    return {product, std::fma(a, b, -product)};
}

}  // namespace endmill
