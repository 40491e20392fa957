// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to interference
#pragma once

#include <cmath>

namespace endmill {

/// A number as the unevaluated sum of two doubles, some 31 digits, for the few places
/// where rounding would be seen. Operators round to about 1e-31 of their result; only
/// finite numbers, far from overflow and underflow.
/// Source: T. J. Dekker, A floating-point technique for extending the available precision,
/// 1971; with a fused multiplication.
class DoubleDouble {
public:
    DoubleDouble(double value = 0) : high_{value} {}  // NOLINT: numbers convert

    double value() const { return high_; }  ///< the nearest double

    friend DoubleDouble operator-(const DoubleDouble& a)
    {
        return DoubleDouble{-a.high_, -a.low_};
    }

    friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b)
    {
        const DoubleDouble highs = sum(a.high_, b.high_);
        const DoubleDouble lows = sum(a.low_, b.low_);
        const DoubleDouble once = ordered_sum(highs.high_, highs.low_ + lows.high_);
        return ordered_sum(once.high_, once.low_ + lows.low_);
    }

    friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b)
    {
        return a + -b;
    }

    friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b)
    {
        const double high = a.high_ * b.high_;
        const double error = std::fma(a.high_, b.high_, -high);
        return ordered_sum(high, error + (a.high_ * b.low_ + a.low_ * b.high_));
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

    // a + b without an error.
    static DoubleDouble sum(double a, double b)
    {
        const double high = a + b;
        const double part = high - a;
        return {high, (a - (high - part)) + (b - part)};
    }

    // The same for |a| >= |b|.
    static DoubleDouble ordered_sum(double a, double b)
    {
        const double high = a + b;
        return {high, b - (high - a)};
    }

    double high_ = 0;
    double low_ = 0;
};

}  // namespace endmill
