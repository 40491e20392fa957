// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include <Eigen/Core>

namespace endmill {

/// The same as `turn`, by exact arithmetic throughout. Below 1 us, but for coordinates
/// beyond 1e153 or, not being zero, below 1e-145: 10 us or so.
int exact_turn(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
               const Eigen::Vector2d& other_from, const Eigen::Vector2d& other_to);

/// How the direction of the segment `other_from`, `other_to` is turned against that of
/// `from`, `to`: 1 to the left, -1 to the right, 0 if they are parallel or one has no
/// length. The sign of (to - from) x (other_to - other_from).
///
/// Exact for all finite coordinates, also where that product is too small or too large for
/// a double. Some 2 ns where rounding leaves no doubt.
///
/// With e = 2^-53 the rounded products a, b differ from the true ones by (3 e + 4 e^2) of
/// theirs and, where they underflow, by 2^-1074 each; so a rounded difference beyond
/// 4 e (|a| + |b|) + 2^-1070 has the true sign, its own roundings included.
/// \pre the coordinates are finite.
inline int turn(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                const Eigen::Vector2d& other_from, const Eigen::Vector2d& other_to)
{
    const double a = (to.x() - from.x()) * (other_to.y() - other_from.y());
    const double b = (to.y() - from.y()) * (other_to.x() - other_from.x());
    const double difference = a - b;
    const double doubt = 0x1p-51 * (std::abs(a) + std::abs(b)) + 0x1p-1070;
    if (difference > doubt)
        return 1;
    if (difference < -doubt)
        return -1;
    return exact_turn(from, to, other_from, other_to);
}

/// On which side of the line from p to q the point r lies: 1 left, -1 right, 0 on it, or
/// if p = q. As exact and as fast as `turn`.
/// \pre the coordinates are finite.
inline int orientation(const Eigen::Vector2d& p, const Eigen::Vector2d& q,
                       const Eigen::Vector2d& r)
{
    return turn(p, q, p, r);
}

}  // namespace endmill
