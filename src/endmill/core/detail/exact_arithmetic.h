// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace endmill {

/// \file
/// Floating-point arithmetic without rounding, or with twice the digits of a double.
///
/// The building block is the error-free transformation: the rounding error of a sum or a
/// product of two doubles is itself a double and can be computed. `ExactPair` holds a
/// rounded result with its error, `ExactSum` adds any few doubles exactly, and
/// `DoubleDouble` rounds to 31 digits. All of it needs the compiler to keep the order of
/// operations and to contract none, which the build asks for.

/// The rounded sum or product of two doubles and its rounding error. Their sum is the
/// exact result unless the error underflows.
struct ExactPair {
    double rounded;  ///< the result, rounded to nearest
    /// The rounding error, at most half a unit in the last place of `rounded`.
    double rest;
};

/// The sum a + b with its rounding error. \pre the sum does not overflow.
/// Source: [KnuthSeminumerical, section 4.2.2, theorem B].
inline ExactPair two_sum(double a, double b)
{
    const double sum = a + b;
    const double b_part = sum - a;
    return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// The same for ordered terms, with half the operations. \pre |a| >= |b|, or a = 0.
/// Source: [Shewchuk, theorem 6].
inline ExactPair fast_two_sum(double a, double b)
{
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

/// The product a b with its rounding error. \pre it does not overflow. The pair is exact
/// unless its error underflows.
inline ExactPair two_product(double a, double b)
{
    const double product = a * b;
    return {product, std::fma(a, b, -product)};
}

/// A sum of at most 16 doubles, kept without rounding as an expansion: parts whose digits
/// do not overlap, in order of rising size.
/// Source: [Shewchuk, theorem 10], GROW-EXPANSION with zero elimination.
class ExactSum {
public:
    /// Adds `term`. \pre fewer than 16 terms were added before.
    void add(double term)
    {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            const ExactPair next = two_sum(term, parts_[i]);
            if (next.rest != 0)
                parts_[kept++] = next.rest;
            term = next.rounded;
        }
        if (term != 0)
            parts_[kept++] = term;
        count_ = kept;
    }

    /// Adds the product a b; it counts as two terms.
    void add_product(double a, double b)
    {
        const ExactPair product = two_product(a, b);
        add(product.rest);
        add(product.rounded);
    }

    /// Sign of the sum: 1, 0 or -1. The largest part outweighs all others together.
    int sign() const
    {
        if (count_ == 0)
            return 0;
        return parts_[count_ - 1] > 0 ? 1 : -1;
    }

private:
    std::array<double, 16> parts_{};
    std::size_t count_ = 0;
};

/// A number as the unevaluated sum of two doubles, about 31 digits. It serves the few
/// places where the rounding of a double would change the result.
///
/// With u = 2^-53, each operation errs by less than 16 u^2 (about 2e-31) of its result; a
/// sum of terms of unlike sign errs by 16 u^2 of the terms' sizes. Only finite numbers
/// far from overflow and underflow are supported.
/// Source: [JoldesMullerPopescu, algorithms 6, 12 and 18].
class DoubleDouble {
public:
    DoubleDouble(double value = 0)
        : high_{value} {}  // NOLINT: numbers convert implicitly

    /// The exact sum a + b.
    static DoubleDouble sum_of(double a, double b) { return DoubleDouble{two_sum(a, b)}; }

    double value() const { return high_; }  ///< the nearest double
    double rest() const { return low_; }    ///< the number less `value()`

    /// The negated number, exactly.
    friend DoubleDouble operator-(const DoubleDouble& a)
    {
        return DoubleDouble{-a.high_, -a.low_};
    }

    /// The sum a + b.
    friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b)
    {
        const DoubleDouble highs = sum_of(a.high_, b.high_);
        const DoubleDouble lows = sum_of(a.low_, b.low_);
        const DoubleDouble once = ordered_sum(highs.high_, highs.low_ + lows.high_);
        return ordered_sum(once.high_, once.low_ + lows.low_);
    }

    /// The difference a - b.
    friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b)
    {
        return a + -b;
    }

    /// The product a b.
    friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b)
    {
        const ExactPair highs = two_product(a.high_, b.high_);
        return ordered_sum(highs.rounded,
                           highs.rest + (a.high_ * b.low_ + a.low_ * b.high_));
    }

    /// The quotient a / b, by two steps of long division. \pre b is not zero.
    friend DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b)
    {
        const double first = a.high_ / b.high_;
        const DoubleDouble rest = a - b * first;
        const double second = rest.high_ / b.high_;
        const DoubleDouble last = rest - b * second;
        return DoubleDouble{first} + second + last.high_ / b.high_;
    }

    /// The square root, by one Newton step from the root of the nearest double; 0 for a
    /// number that is not positive.
    friend DoubleDouble sqrt(const DoubleDouble& a)
    {
        if (!(a.high_ > 0))
            return 0.0;
        const double root = std::sqrt(a.high_);
        const DoubleDouble rest = a - DoubleDouble{root} * root;
        return DoubleDouble{root} + rest.high_ / (2 * root);
    }

    /// Comparisons use all digits.
    friend bool operator<(const DoubleDouble& a, const DoubleDouble& b)
    {
        return a.high_ < b.high_ || (a.high_ == b.high_ && a.low_ < b.low_);
    }
    /// See operator<.
    friend bool operator>(const DoubleDouble& a, const DoubleDouble& b) { return b < a; }
    /// See operator<.
    friend bool operator<=(const DoubleDouble& a, const DoubleDouble& b)
    {
        return !(b < a);
    }
    /// See operator<.
    friend bool operator>=(const DoubleDouble& a, const DoubleDouble& b)
    {
        return !(a < b);
    }

private:
    DoubleDouble(double high, double low) : high_{high}, low_{low} {}

    explicit DoubleDouble(const ExactPair& pair) : high_{pair.rounded}, low_{pair.rest} {}

    static DoubleDouble ordered_sum(double a, double b)
    {
        return DoubleDouble{fast_two_sum(a, b)};
    }

    double high_ = 0;
    double low_ = 0;
};

}  // namespace endmill
