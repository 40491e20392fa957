// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/quartic_roots.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "endmill/core/detail/bracketed_newton.h"

// `roots` descends to the quadratic, whose roots are closed, and comes back up: the roots
// of the derivative split the interval into parts on which the polynomial is monotonic,
// so each part with a change of sign holds exactly one root.

namespace endmill {
namespace {

// A Newton step that changes the root in u by less ends the iteration; u is of the order
// of 1.
constexpr double least_step = 1e-13;

// Coefficients of a polynomial of degree N - 1, the constant one first.
template <std::size_t N>
using Polynomial = std::array<double, N>;

// Ascending places; the first `count` are valid.
struct Places {
    std::array<double, 4> at;
    int count = 0;

    void add(double place) { at[count++] = place; }
};

// Value at u by Horner's rule.
template <std::size_t N>
double value(const Polynomial<N>& c, double u)
{
    double sum = c[N - 1];
    for (std::size_t k = N - 1; k-- > 0;)
        sum = sum * u + c[k];
    return sum;
}

template <std::size_t N>
Polynomial<N - 1> derivative(const Polynomial<N>& c)
{
    Polynomial<N - 1> d;
    for (std::size_t k = 1; k < N; ++k)
        d[k - 1] = static_cast<double>(k) * c[k];
    return d;
}

// The root between `low` and `high`, where the polynomial has different signs.
template <std::size_t N>
double root_between(const Polynomial<N>& c, const Polynomial<N - 1>& d, double low,
                    double high)
{
    return bracketed_newton({low, high, value(c, high) > 0, (low + high) / 2}, least_step,
                            [&](double u) {
                                return ValueAndSlope{value(c, u), value(d, u)};
                            });
}

// Roots of a quadratic. Leading coefficients may be 0.
Places roots(const Polynomial<3>& c, double low, double high)
{
    Places found;
    const double discriminant = c[1] * c[1] - 4 * c[2] * c[0];
    if (discriminant < 0)
        return found;
    const double q = -(c[1] + std::copysign(std::sqrt(discriminant), c[1])) / 2;
    double first = c[2] != 0 ? q / c[2] : high + 1;
    double second = q != 0 ? c[0] / q : first;
    if (second < first)
        std::swap(first, second);
    for (const double root : {first, second})
        if (root > low && root < high)
            found.add(root);
    return found;
}

// Roots of a polynomial of higher degree.
template <std::size_t N>
Places roots(const Polynomial<N>& c, double low, double high)
{
    const Polynomial<N - 1> d = derivative(c);
    const Places turns = roots(d, low, high);
    Places found;
    double from = low;
    double at_from = value(c, low);
    for (int k = 0; k <= turns.count; ++k) {
        const double to = k < turns.count ? turns.at[k] : high;
        const double at_to = value(c, to);
        if ((at_from > 0) != (at_to > 0))
            found.add(root_between(c, d, from, to));
        from = to;
        at_from = at_to;
    }
    return found;
}

}  // namespace

RootsAndExtrema roots_and_extrema(const Quartic& quartic, double low, double high)
{
    const Places turns = roots(derivative(quartic), low, high);
    const Places zeros = roots(quartic, low, high);
    RootsAndExtrema found;
    const auto end =
        std::merge(zeros.at.begin(), zeros.at.begin() + zeros.count, turns.at.begin(),
                   turns.at.begin() + turns.count, found.at.begin());
    found.count = static_cast<int>(end - found.at.begin());
    return found;
}

}  // namespace endmill
