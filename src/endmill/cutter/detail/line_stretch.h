// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include <Eigen/Core>

namespace endmill {

/// A stretch of a line, low <= t <= high; empty if low > high.
struct Stretch {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();

    bool is_empty() const { return !(low <= high); }  ///< also if an end is NaN

    /// Nothing.
    static Stretch none()
    {
        return {std::numeric_limits<double>::infinity(),
                -std::numeric_limits<double>::infinity()};
    }
};

/// What both stretches share.
Stretch shared(const Stretch& a, const Stretch& b);

/// The least stretch that holds both; of an empty one and another, the other.
Stretch spanned(const Stretch& a, const Stretch& b);

/// Where value + t rate >= 0.
Stretch where_positive(double value, double rate);

/// Where |offset + t rate| <= radius: a line in the plane, or one along a cylinder. A
/// line that only touches has a stretch of one point, or none, as rounding has it.
Stretch within_circle(const Eigen::Vector2d& offset, const Eigen::Vector2d& rate,
                      double radius);

}  // namespace endmill
