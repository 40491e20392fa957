// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "endmill/surface/surface_jet.h"

/// \file
/// Arithmetic of intervals: each result contains the results for all numbers of the
/// operands, except for rounding, which is not included.

namespace endmill {

inline Interval operator-(const Interval& a)
{
    return {-a.high, -a.low};
}

inline Interval operator+(const Interval& a, const Interval& b)
{
    return {a.low + b.low, a.high + b.high};
}

inline Interval operator-(const Interval& a, const Interval& b)
{
    return {a.low - b.high, a.high - b.low};
}

inline Interval operator*(const Interval& a, const Interval& b)
{
    const double p = a.low * b.low;
    const double q = a.low * b.high;
    const double r = a.high * b.low;
    const double s = a.high * b.high;
    return {std::min(std::min(p, q), std::min(r, s)),
            std::max(std::max(p, q), std::max(r, s))};
}

inline Interval operator*(double a, const Interval& b)
{
    return a >= 0 ? Interval{a * b.low, a * b.high} : Interval{a * b.high, a * b.low};
}

/// Whether a number lies in the interval.
inline bool contains(const Interval& a, double number)
{
    return a.low <= number && number <= a.high;
}

/// Whether `inner` lies in `outer`.
inline bool contains(const Interval& outer, const Interval& inner)
{
    return outer.low <= inner.low && inner.high <= outer.high;
}

/// One over the interval.
/// \return all numbers if the interval contains 0.
inline Interval reciprocal(const Interval& a)
{
    if (contains(a, 0))
        return {-std::numeric_limits<double>::infinity(),
                std::numeric_limits<double>::infinity()};
    return {1 / a.high, 1 / a.low};
}

/// The squares of the numbers of the interval.
inline Interval square(const Interval& a)
{
    const double low = a.low * a.low;
    const double high = a.high * a.high;
    return {contains(a, 0) ? 0 : std::min(low, high), std::max(low, high)};
}

/// The square roots of the numbers of the interval that are not negative.
inline Interval square_root(const Interval& a)
{
    return {std::sqrt(std::max(0.0, a.low)), std::sqrt(std::max(0.0, a.high))};
}

/// The smallest interval that contains both.
inline Interval hull(const Interval& a, const Interval& b)
{
    return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

/// The numbers in both, which are assumed to meet.
inline Interval common_part(const Interval& a, const Interval& b)
{
    return {std::max(a.low, b.low), std::min(a.high, b.high)};
}

/// The greatest absolute value.
inline double magnitude(const Interval& a)
{
    return std::max(-a.low, a.high);
}

/// All numbers from -a to a.
inline Interval around_zero(double a)
{
    return {-a, a};
}

}  // namespace endmill
