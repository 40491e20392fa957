// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/rounded_crossing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "endmill/core/detail/exact_arithmetic.h"

namespace endmill {
namespace {

// Factor of an error bound that is itself computed in doubles: a few roundings, and the
// terms of second order that the bound omits, are far below a thousandth of it.
constexpr double doubt_margin = 1.001;

// The double to which all numbers within `error` of `value` are rounded, if it is the
// same one.
std::optional<double> rounded(const DoubleDouble& value, double error)
{
    const double low = value.value() + (value.rest() - error);
    const double high = value.value() + (value.rest() + error);
    // Near the smallest and the largest doubles a pair of doubles loses its low part. NaN
    // fails the test as well.
    constexpr double smallest = 0x1p-400;
    constexpr double largest = 0x1p+400;
    const double size = std::abs(low);
    if (low == high && smallest < size && size < largest)
        return low;
    return std::nullopt;
}

// A share of a segment, counted from its first end, with an error bound.
struct Share {
    DoubleDouble value;
    double error;
};

// The correctly rounded point at `share` of the way from a to b, or nothing if the error
// bound leaves two candidates.
std::optional<double> rounded_between(double a, double b, const Share& share)
{
    const DoubleDouble way = DoubleDouble::sum_of(b, -a);
    const DoubleDouble value = DoubleDouble{a} + share.value * way;
    const double error =
        std::abs(way.value()) * (share.error + 0x1p-98) + 0x1p-100 * std::abs(a);
    return rounded(value, doubt_margin * error);
}

}  // namespace

SectionPoint rounded_crossing(const SectionLine& p, const SectionLine& q)
{
    // Let f be the signed area above p. The crossing divides q as f(a) : -f(b).
    const DoubleDouble ds = DoubleDouble::sum_of(p.b[0], -p.a[0]);
    const DoubleDouble dz = DoubleDouble::sum_of(p.b[1], -p.a[1]);
    const DoubleDouble left_a = ds * DoubleDouble::sum_of(q.a[1], -p.a[1]);
    const DoubleDouble right_a = dz * DoubleDouble::sum_of(q.a[0], -p.a[0]);
    const DoubleDouble left_b = ds * DoubleDouble::sum_of(q.b[1], -p.a[1]);
    const DoubleDouble right_b = dz * DoubleDouble::sum_of(q.b[0], -p.a[0]);
    const DoubleDouble area = left_a - right_a;
    const DoubleDouble span = area - (left_b - right_b);
    const double doubt =
        0x1p-99 * std::max(std::abs(left_a.value()) + std::abs(right_a.value()),
                           std::abs(left_b.value()) + std::abs(right_b.value())) +
        std::numeric_limits<double>::min();
    const Share share{area / span, doubt_margin * doubt / std::abs(span.value())};
    const auto s = rounded_between(q.a[0], q.b[0], share);
    const auto z = rounded_between(q.a[1], q.b[1], share);
    if (s && z)
        return {*s, *z};
    const SectionPoint exact = exact_crossing(p, q);
    return {s.value_or(exact[0]), z.value_or(exact[1])};
}

double rounded_height(const SectionLine& line, double s)
{
    const DoubleDouble run = DoubleDouble::sum_of(line.b[0], -line.a[0]);
    const Share share{DoubleDouble::sum_of(s, -line.a[0]) / run,
                      std::numeric_limits<double>::min() / std::abs(run.value())};
    const auto z = rounded_between(line.a[1], line.b[1], share);
    return z ? *z : exact_height(line, s);
}

}  // namespace endmill
