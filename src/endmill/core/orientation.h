// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include <Eigen/Core>

#include "endmill/core/vec.h"

namespace endmill {

/// \file
/// Exact sign predicates on points whose coordinates are doubles. Each predicate
/// evaluates its determinant in double precision, with a bound on the rounding error. It
/// repeats the evaluation without rounding only if the bound does not determine the sign.
/// The evaluation is always inlined: a call would take longer than it.

/// The same result as `turn`, always by exact arithmetic. Takes less than 1 us, but about
/// 10 us if a coordinate is above 1e153 in size, or below 1e-145 and not zero.
int exact_turn(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
               const Eigen::Vector2d& other_from, const Eigen::Vector2d& other_to);

/// The sense of rotation from the segment (`from`, `to`) to the segment (`other_from`,
/// `other_to`): the sign of (to - from) x (other_to - other_from).
///
/// Exact for all finite coordinates, even if that product overflows or underflows. Takes
/// about 2 ns where the rounded product decides.
///
/// Error bound: with e = 2^-53, the rounded products a and b differ from the true ones by
/// at most (3 e + 4 e^2) of their size, and by 2^-1074 where they underflow. A rounded
/// difference beyond 4 e (|a| + |b|) + 2^-1070, which includes the roundings of the bound
/// itself, therefore has the true sign.
/// \pre the coordinates are finite.
/// \return 1 if it turns to the left, -1 to the right, 0 if the segments are parallel or
///         one has no length.
[[gnu::always_inline]] inline int turn(const Eigen::Vector2d& from,
                                       const Eigen::Vector2d& to,
                                       const Eigen::Vector2d& other_from,
                                       const Eigen::Vector2d& other_to)
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

/// The side of the directed line from p to q on which the point r lies. As exact and as
/// fast as `turn`.
/// \pre the coordinates are finite.
/// \return 1 if left, -1 if right, 0 if r lies on the line or p = q.
[[gnu::always_inline]] inline int orientation(const Eigen::Vector2d& p,
                                              const Eigen::Vector2d& q,
                                              const Eigen::Vector2d& r)
{
    return turn(p, q, p, r);
}

/// Whether three points in space lie on one line. Exact; always true if two of the points
/// are equal.
/// Source: [Shewchuk, section 4], the filter of ORIENT2D, for the projections of the
/// triangle onto the three coordinate planes.
/// \pre each coordinate is 0 or between 1e-140 and 1e140 in size. Beyond that range
///      products overflow or underflow and the answer may be wrong.
bool are_collinear(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace endmill
