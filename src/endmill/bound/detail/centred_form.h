// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "endmill/bound/detail/interval_arithmetic.h"

namespace endmill {

/// A function of three variables, each from -1 to 1: its value in the middle, and
/// enclosures of its range and of its derivatives. By the mean value theorem the range
/// lies within the sum of the derivatives' magnitudes of the middle value, which each
/// operation uses. The function may have kinks; its derivatives are then those on all sides.
struct CentredForm {
    double middle = 0;                 ///< value where all variables are 0
    Interval range{0, 0};              ///< of the values
    std::array<Interval, 3> slopes{};  ///< of the derivatives

    /// The form with a range that uses the mean value theorem.
    static CentredForm of(double middle, const Interval& range,
                          const std::array<Interval, 3>& slopes)
    {
        const double far =
            magnitude(slopes[0]) + magnitude(slopes[1]) + magnitude(slopes[2]);
        return {middle, common_part(range, {middle - far, middle + far}), slopes};
    }

    /// A constant.
    static CentredForm constant(double value) { return {value, {value, value}, {}}; }
};

inline CentredForm operator+(const CentredForm& a, const CentredForm& b)
{
    return CentredForm::of(a.middle + b.middle, a.range + b.range,
                           {a.slopes[0] + b.slopes[0], a.slopes[1] + b.slopes[1],
                            a.slopes[2] + b.slopes[2]});
}

inline CentredForm operator-(const CentredForm& a, const CentredForm& b)
{
    return CentredForm::of(a.middle - b.middle, a.range - b.range,
                           {a.slopes[0] - b.slopes[0], a.slopes[1] - b.slopes[1],
                            a.slopes[2] - b.slopes[2]});
}

inline CentredForm operator*(double a, const CentredForm& b)
{
    return {
        a * b.middle, a * b.range, {a * b.slopes[0], a * b.slopes[1], a * b.slopes[2]}};
}

inline CentredForm operator*(const CentredForm& a, const CentredForm& b)
{
    CentredForm result;
    for (std::size_t k = 0; k < 3; ++k)
        result.slopes[k] = a.slopes[k] * b.range + b.slopes[k] * a.range;
    return CentredForm::of(a.middle * b.middle, a.range * b.range, result.slopes);
}

/// One over a function that is not zero.
inline CentredForm reciprocal(const CentredForm& a)
{
    const Interval range = reciprocal(a.range);
    const Interval slope = -square(range);
    return CentredForm::of(
        1 / a.middle, range,
        {slope * a.slopes[0], slope * a.slopes[1], slope * a.slopes[2]});
}

/// The root of a positive function.
inline CentredForm square_root(const CentredForm& a)
{
    const Interval range = square_root(a.range);
    const Interval slope = 0.5 * reciprocal(range);
    return CentredForm::of(
        std::sqrt(a.middle), range,
        {slope * a.slopes[0], slope * a.slopes[1], slope * a.slopes[2]});
}

/// The lesser of a function and 0.
inline CentredForm negative_part(const CentredForm& a)
{
    if (a.range.high <= 0)
        return a;
    if (a.range.low >= 0)
        return {};
    const Interval share{0, 1};
    return CentredForm::of(
        std::min(0.0, a.middle), {a.range.low, 0},
        {share * a.slopes[0], share * a.slopes[1], share * a.slopes[2]});
}

}  // namespace endmill
