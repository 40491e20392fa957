// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/detail/bernstein_polynomial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "endmill/core/detail/bracketed_newton.h"
#include "endmill/surface/detail/cubic_root.h"

namespace endmill {
namespace {

// A piece narrower than this is itself the root.
constexpr double least_width = 0x1p-50;

struct Halves {
    BernsteinPolynomial low;
    BernsteinPolynomial high;
};

// De Casteljau's algorithm at t: the left edge of the triangle is the lower part, the
// right edge the upper part.
Halves split(const BernsteinPolynomial& polynomial, double t)
{
    Halves parts{polynomial, polynomial};
    const std::size_t degree = polynomial.size() - 1;
    for (std::size_t level = 1; level <= degree; ++level) {
        for (std::size_t k = 0; k + level <= degree; ++k)
            parts.high[k] = (1 - t) * parts.high[k] + t * parts.high[k + 1];
        parts.low[level] = parts.high[0];
    }
    return parts;
}

// Value and derivative by de Casteljau's algorithm.
ValueAndSlope evaluate(BernsteinPolynomial b, double t)
{
    double slope = 0;
    for (std::size_t left = b.size() - 1; left > 0; --left) {
        if (left == 1)
            slope = static_cast<double>(b.size() - 1) * (b[1] - b[0]);
        for (std::size_t k = 0; k < left; ++k)
            b[k] = (1 - t) * b[k] + t * b[k + 1];
    }
    return {b[0], slope};
}

// Whether the coefficients change their sign exactly once, from below zero: then there is
// exactly one root (Descartes' rule for Bernstein coefficients).
bool has_one_sign_change(const BernsteinPolynomial& b)
{
    const auto first = std::ranges::find_if(b, [](double c) { return c >= 0; });
    // A last coefficient of zero would be a root of its own.
    return b.back() > 0 && std::all_of(first, b.end(), [](double c) { return c >= 0; });
}

// The only root of a polynomial that rises from below zero to zero or above. Not
// `bracketed_newton`: a narrow bracket, too, ends the search.
double only_root(const BernsteinPolynomial& b)
{
    constexpr int most_steps = 80;
    double low = 0;
    double high = 1;
    double t = -b.front() / (b.back() - b.front());
    for (int step = 0; step < most_steps && high - low > least_width; ++step) {
        const ValueAndSlope here = evaluate(b, t);
        (here.value < 0 ? low : high) = t;
        const double next = root_step(low, high, t, here).next;
        const double length = std::abs(next - t);
        t = next;
        if (length <= least_width)
            break;
    }
    return t;
}

// The first root on a piece of this width, by recursive halving from the left.
std::optional<double> first_root(const BernsteinPolynomial& b, double width)
{
    if (b.front() >= 0)
        return 0;
    if (*std::ranges::max_element(b) < 0)
        // The polynomial lies in the convex hull of its coefficients.
        return std::nullopt;
    if (has_one_sign_change(b))
        return only_root(b);
    if (width < least_width)
        return 1;
    const Halves parts = split(b, 0.5);
    if (const auto t = first_root(parts.low, width / 2))
        return *t / 2;
    if (const auto t = first_root(parts.high, width / 2))
        return 0.5 + *t / 2;
    return std::nullopt;
}

}  // namespace

BernsteinPolynomial restricted(BernsteinPolynomial polynomial, double from, double to)
{
    if (to < 1)
        polynomial = split(polynomial, to).low;
    if (from > 0)
        polynomial = split(polynomial, from / to).high;
    return polynomial;
}

std::optional<double> first_rise_to_zero(const BernsteinPolynomial& polynomial)
{
    if (polynomial.size() == 4)
        return first_rise_to_zero(
            std::array{polynomial[0], polynomial[1], polynomial[2], polynomial[3]});
    return first_root(polynomial, 1);
}

}  // namespace endmill
