// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// doubles whose products neither overflow nor underflow, and take some 3 ns where rounding
// leaves no doubt, else some 0.2 us by intervals or 2 us by rational numbers.

#include <cmath>

#include "endmill/core/vec.h"

namespace endmill {

/// A rounded determinant, and the sum of the absolute values of its six products.
struct RoundedDeterminant {
    double value;
    double size;

    /// det(p, a, b).
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

    /// Its sign; 0 if it is in doubt. With u = 2^-53 the value is off by less than 6 u of the
    /// true size, 2 u more for each rounded difference among a and b, and so is the size.
    int certain_sign() const
    {
        const double doubt = 0x1p-49 * size;
        return (value > doubt) - (value < -doubt);
    }
};

/// The same as `turn_about`, by exact arithmetic throughout.
int exact_turn_about(const Vec3& axis, const Vec3& a, const Vec3& b);

/// The same as `turn_along`, by exact arithmetic throughout.
int exact_turn_along(const Vec3& axis, const Vec3& a, const Vec3& b, const Vec3& c);

/// The same as `order_along`, by exact arithmetic throughout.
int exact_order_along(const Vec3& axis, const Vec3& line, const Vec3& a, const Vec3& b);

/// Sign of det(axis, a, b): 1 if the great circle from `a` to `b` has `axis` on its left, seen
/// from outside the sphere; -1 on its right; 0 if the three lie in one plane.
inline int turn_about(const Vec3& axis, const Vec3& a, const Vec3& b)
{
    const int sign = RoundedDeterminant{axis, a, b}.certain_sign();
    return sign != 0 ? sign : exact_turn_about(axis, a, b);
}

/// Sign of det(axis, b - a, c - a): 1 if a, b, c turn counter-clockwise, seen from far along
/// `axis`.
inline int turn_along(const Vec3& axis, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const int sign = RoundedDeterminant{axis, b - a, c - a}.certain_sign();
    return sign != 0 ? sign : exact_turn_along(axis, a, b, c);
}

/// Sign of det(axis, line, b - a): 1 if, seen from far along `axis`, b lies to the left of the
/// parallel to `line` through a.
inline int order_along(const Vec3& axis, const Vec3& line, const Vec3& a, const Vec3& b)
{
    const int sign = RoundedDeterminant{axis, line, b - a}.certain_sign();
    return sign != 0 ? sign : exact_order_along(axis, line, a, b);
}

/// The same as `side_of`, by exact arithmetic throughout.
int exact_side_of(const Vec3& a, const Vec3& b);

/// Sign of a . b: on which side of the great circle about `a` the direction `b` lies. The
/// rounded product is off by less than 3 u of the sum of the absolute values of its terms.
inline int side_of(const Vec3& a, const Vec3& b)
{
    const double value = a.dot(b);
    const double doubt = 0x1p-50 * a.cwiseAbs().dot(b.cwiseAbs());
    if (value > doubt)
        return 1;
    return value < -doubt ? -1 : exact_side_of(a, b);
}

}  // namespace endmill
