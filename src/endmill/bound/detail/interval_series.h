// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "endmill/bound/detail/interval_arithmetic.h"

namespace endmill {

/// Enclosures of the Taylor coefficients of a function of u and v at all places of a box,
/// up to a total order: coefficient (i, j) encloses the derivative i times in u and j
/// times in v, divided by i! j!. Sums, products, quotients and roots enclose those of
/// the functions.
template <int Order>
class IntervalSeries {
public:
    /// Coefficient (i, j), i + j <= Order.
    Interval& operator()(int i, int j) { return coefficients_[number(i, j)]; }
    /// Coefficient (i, j), i + j <= Order.
    const Interval& operator()(int i, int j) const { return coefficients_[number(i, j)]; }

    /// The series of the derivative in u.
    IntervalSeries<Order - 1> derivative_u() const
    {
        IntervalSeries<Order - 1> result;
        for (int n = 0; n < Order; ++n)
            for (int j = 0; j <= n; ++j)
                result(n - j, j) = (n - j + 1.0) * (*this)(n - j + 1, j);
        return result;
    }

    /// The series of the derivative in v.
    IntervalSeries<Order - 1> derivative_v() const
    {
        IntervalSeries<Order - 1> result;
        for (int n = 0; n < Order; ++n)
            for (int j = 0; j <= n; ++j)
                result(n - j, j) = (j + 1.0) * (*this)(n - j, j + 1);
        return result;
    }

    /// The series up to a lower order.
    template <int Lower>
    IntervalSeries<Lower> up_to() const
    {
        IntervalSeries<Lower> result;
        for (int n = 0; n <= Lower; ++n)
            for (int j = 0; j <= n; ++j)
                result(n - j, j) = (*this)(n - j, j);
        return result;
    }

private:
    static std::size_t number(int i, int j)
    {
        const auto degree = static_cast<std::size_t>(i + j);
        return degree * (degree + 1) / 2 + static_cast<std::size_t>(j);
    }

    std::array<Interval, static_cast<std::size_t>((Order + 1) * (Order + 2) / 2)>
        coefficients_{};
};

template <int Order>
IntervalSeries<Order> operator+(const IntervalSeries<Order>& a,
                                const IntervalSeries<Order>& b)
{
    IntervalSeries<Order> result;
    for (int n = 0; n <= Order; ++n)
        for (int j = 0; j <= n; ++j)
            result(n - j, j) = a(n - j, j) + b(n - j, j);
    return result;
}

template <int Order>
IntervalSeries<Order> operator*(double a, const IntervalSeries<Order>& b)
{
    IntervalSeries<Order> result;
    for (int n = 0; n <= Order; ++n)
        for (int j = 0; j <= n; ++j)
            result(n - j, j) = a * b(n - j, j);
    return result;
}

/// Calls `visit(k, l)` for 0 <= k <= i and 0 <= l <= j.
template <typename Visit>
void visit_lower(int i, int j, const Visit& visit)
{
    for (int k = 0; k <= i; ++k)
        for (int l = 0; l <= j; ++l)
            visit(k, l);
}

template <int Order>
IntervalSeries<Order> operator*(const IntervalSeries<Order>& a,
                                const IntervalSeries<Order>& b)
{
    IntervalSeries<Order> result;
    for (int n = 0; n <= Order; ++n)
        for (int j = 0; j <= n; ++j) {
            Interval sum{0, 0};
            visit_lower(n - j, j,
                        [&](int k, int l) { sum = sum + a(k, l) * b(n - j - k, j - l); });
            result(n - j, j) = sum;
        }
    return result;
}

/// The quotient a / b, where b is not zero.
template <int Order>
IntervalSeries<Order> operator/(const IntervalSeries<Order>& a,
                                const IntervalSeries<Order>& b)
{
    IntervalSeries<Order> result;
    const Interval first = reciprocal(b(0, 0));
    for (int n = 0; n <= Order; ++n)
        for (int j = 0; j <= n; ++j) {
            Interval sum = a(n - j, j);
            visit_lower(n - j, j, [&](int k, int l) {
                if (k + l < n)
                    sum = sum - result(k, l) * b(n - j - k, j - l);
            });
            result(n - j, j) = sum * first;
        }
    return result;
}

/// The root of a positive function.
template <int Order>
IntervalSeries<Order> square_root(const IntervalSeries<Order>& a)
{
    IntervalSeries<Order> result;
    result(0, 0) = square_root(a(0, 0));
    const Interval half = 0.5 * reciprocal(result(0, 0));
    for (int n = 1; n <= Order; ++n)
        for (int j = 0; j <= n; ++j) {
            Interval sum = a(n - j, j);
            visit_lower(n - j, j, [&](int k, int l) {
                if (0 < k + l && k + l < n)
                    sum = sum - result(k, l) * result(n - j - k, j - l);
            });
            result(n - j, j) = sum * half;
        }
    return result;
}

}  // namespace endmill
