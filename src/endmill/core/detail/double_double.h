// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "endmill/core/detail/exact_pair.h"

namespace endmill {

/// A number as the unevaluated sum of two doubles, some 31 digits, for the few places
/// where rounding would be seen. Operators round to about 1e-31 of their result; only
/// finite numbers, far from overflow and underflow.
/// With u = 2^-53 each errs by less than 16 u^2 of its result, a sum of unlike signs by
/// 16 u^2 of its terms' sizes.
/// Source: Joldes, Muller, Popescu, Tight and rigorous error bounds for basic building
/// blocks of double-word arithmetic (2017), algorithms 6, 12 and 18.
class DoubleDouble {
public:
    DoubleDouble(double value = 0) : high_{value} {}  // NOLINT: numbers convert

    /// a + b without an error.
    static DoubleDouble sum_of(double a, double b)
    {
        return DoubleDouble{exact_sum(a, b)};
    }

    double value() const { return high_; }  ///< the nearest double
    double rest() const { return low_; }    ///< what it lacks

    friend DoubleDouble operator-(const DoubleDouble& a)
    {
        return DoubleDouble{-a.high_, -a.low_};
    }

    friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b)
    {
        const DoubleDouble highs = sum_of(a.high_, b.high_);
        const DoubleDouble lows = sum_of(a.low_, b.low_);
        const DoubleDouble once = ordered_sum(highs.high_, highs.low_ + lows.high_);
        return ordered_sum(once.high_, once.low_ + lows.low_);
    }

    friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b)
    {
        return a + -b;
    }

    friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b)
    {
        const ExactPair highs = exact_product(a.high_, b.high_);
        return ordered_sum(highs.rounded,
                           highs.rest + (a.high_ * b.low_ + a.low_ * b.high_));
    }

    friend DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b)
    {
        const double first = a.high_ / b.high_;
        const DoubleDouble rest = a - b * first;
        const double second = rest.high_ / b.high_;
        const DoubleDouble last = rest - b * second;
        return DoubleDouble{first} + second + last.high_ / b.high_;
    }

    /// Square root of a number that is not negative.
    friend DoubleDouble sqrt(const DoubleDouble& a)
    {
        if (!(a.high_ > 0))
            return 0.0;
        const double root = std::sqrt(a.high_);
        const DoubleDouble rest = a - DoubleDouble{root} * root;
        return DoubleDouble{root} + rest.high_ / (2 * root);
    }

    friend bool operator<(const DoubleDouble& a, const DoubleDouble& b)
    {
        return a.high_ < b.high_ || (a.high_ == b.high_ && a.low_ < b.low_);
    }
    friend bool operator>(const DoubleDouble& a, const DoubleDouble& b) { return b < a; }
    friend bool operator<=(const DoubleDouble& a, const DoubleDouble& b)
    {
        return !(b < a);
    }
    friend bool operator>=(const DoubleDouble& a, const DoubleDouble& b)
    {
        return !(a < b);
    }

private:
    DoubleDouble(double high, double low) : high_{high}, low_{low} {}

    explicit DoubleDouble(const ExactPair& pair) : high_{pair.rounded}, low_{pair.rest} {}

    static DoubleDouble ordered_sum(double a, double b)
    {
        return DoubleDouble{exact_ordered_sum(a, b)};
    }

    double high_ = 0;
    double low_ = 0;
};

}  // namespace endmill
