// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "endmill/core/vec.h"

/// \file
/// Exact sign predicates on the sphere. The signs are exact for doubles whose products
/// neither overflow nor underflow. A predicate takes about 3 ns if rounding errors cannot
/// change the sign, else 0.2 us by interval arithmetic or 2 us by rational numbers.

namespace endmill {

/// A determinant in doubles with a bound of its rounding error.
struct RoundedDeterminant {
    double value;
    double size;  ///< sum of the absolute values of its six products

    /// Computes det(p, a, b).
    RoundedDeterminant(const Vec3& p, const Vec3& a, const Vec3& b) : value{0}, size{0}
    {
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3;
            const int k = (i + 2) % 3;
            const double forward = a[j] * b[k];
            const double backward = a[k] * b[j];
            value += p[i] * (forward - backward);
            size += std::abs(p[i]) * (std::abs(forward) + std::abs(backward));
        }
    }

    /// The sign, or 0 if rounding may have changed it. With u = 2^-53 the relative error
    /// of the value is below 6 u of the size, and 2 u more for each of a and b that is a
    /// rounded difference; the size has the same relative error.
    int certain_sign() const
    {
        const double doubt = 0x1p-49 * size;
        return (value > doubt) - (value < -doubt);
    }
};

/// `turn_about` in exact arithmetic only.
int exact_turn_about(const Vec3& axis, const Vec3& a, const Vec3& b);

/// `turn_along` in exact arithmetic only.
int exact_turn_along(const Vec3& axis, const Vec3& a, const Vec3& b, const Vec3& c);

/// `order_along` in exact arithmetic only.
int exact_order_along(const Vec3& axis, const Vec3& line, const Vec3& a, const Vec3& b);

/// Sign of det(axis, a, b): 1 if `axis` lies to the left of the great circle from `a` to
/// `b`, seen from outside the sphere; -1 if it lies to the right; 0 if the three vectors
/// lie in a plane.
inline int turn_about(const Vec3& axis, const Vec3& a, const Vec3& b)
{
    const int sign = RoundedDeterminant{axis, a, b}.certain_sign();
    return sign != 0 ? sign : exact_turn_about(axis, a, b);
}

/// Sign of det(axis, b - a, c - a): 1 if a, b, c turn counter-clockwise in the
/// orthographic projection along `axis`.
inline int turn_along(const Vec3& axis, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const int sign = RoundedDeterminant{axis, b - a, c - a}.certain_sign();
    return sign != 0 ? sign : exact_turn_along(axis, a, b, c);
}

/// Sign of det(axis, line, b - a): 1 if b lies to the left of the parallel to `line`
/// through a, in the orthographic projection along `axis`.
inline int order_along(const Vec3& axis, const Vec3& line, const Vec3& a, const Vec3& b)
{
    const int sign = RoundedDeterminant{axis, line, b - a}.certain_sign();
    return sign != 0 ? sign : exact_order_along(axis, line, a, b);
}

/// `side_of` in exact arithmetic only.
int exact_side_of(const Vec3& a, const Vec3& b);

/// Sign of a . b: 1 if `b` is less than 90 degrees from `a`, -1 if more, 0 if it is
/// perpendicular. The error of the rounded product is below 3 u times the sum of the
/// absolute values of its terms.
inline int side_of(const Vec3& a, const Vec3& b)
{
    const double value = a.dot(b);
    const double doubt = 0x1p-50 * a.cwiseAbs().dot(b.cwiseAbs());
    if (value > doubt)
        return 1;
    return value < -doubt ? -1 : exact_side_of(a, b);
}

}  // namespace endmill
