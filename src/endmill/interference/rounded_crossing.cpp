// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/interference/rounded_crossing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace endmill {
namespace {

// A number as the unevaluated sum of two doubles, the second below half a unit in the last
// place of the first: some 106 bits. With u = 2^-53 each operation below errs by less than
// 16 u^2 of its result, a sum of unlike signs by 16 u^2 of its terms' sizes.
// Source: Joldes, Muller, Popescu, Tight and rigorous error bounds for basic building blocks
// of double-word arithmetic (2017), algorithms 6, 12 and 17, whose bounds are 3, 7 and 15 u^2.
struct DoublePair {
    double high;
    double low;
};

DoublePair sum(double a, double b)
{
    const double high = a + b;
    const double b_part = high - a;
    return {high, (a - (high - b_part)) + (b - b_part)};
}

DoublePair sum_of_ordered(double a, double b)  // |a| >= |b|, or a = 0
{
    const double high = a + b;
    return {high, b - (high - a)};
}

// Dekker's, without a fused operation: not every machine has one.
DoublePair product(double a, double b)
{
    constexpr double splitter = 0x1p+27 + 1;
    const auto split = [](double x) {
        const double scaled = splitter * x;
        const double high = scaled - (scaled - x);
        return DoublePair{high, x - high};
    };
    const DoublePair x = split(a);
    const DoublePair y = split(b);
    const double high = a * b;
    const double rest = ((x.high * y.high - high) + x.high * y.low + x.low * y.high);
    return {high, rest + x.low * y.low};
}

DoublePair operator+(const DoublePair& a, const DoublePair& b)
{
    const DoublePair high = sum(a.high, b.high);
    const DoublePair low = sum(a.low, b.low);
    const DoublePair part = sum_of_ordered(high.high, high.low + low.high);
    return sum_of_ordered(part.high, low.low + part.low);
}

DoublePair operator-(const DoublePair& a, const DoublePair& b)
{
    return a + DoublePair{-b.high, -b.low};
}

DoublePair operator*(const DoublePair& a, const DoublePair& b)
{
    const DoublePair high = product(a.high, b.high);
    return sum_of_ordered(high.high, high.low + (a.high * b.low + a.low * b.high));
}

DoublePair operator/(const DoublePair& a, const DoublePair& b)
{
    const double quotient = a.high / b.high;
    const DoublePair rest = a - b * DoublePair{quotient, 0};
    return sum_of_ordered(quotient, rest.high / b.high);
}

// The one double to which all numbers within `error` of `value` are rounded.
std::optional<double> rounded(const DoublePair& value, double error)
{
    const double low = value.high + (value.low - error);
    const double high = value.high + (value.low + error);
    // Near the smallest doubles the pairs lose what they should hold; NaN fails, too.
    constexpr double smallest = 0x1p-400;
    constexpr double largest = 0x1p+400;
    const double size = std::abs(low);
    if (low == high && smallest < size && size < largest)
        return low;
    return std::nullopt;
}

// A share of a segment from one end.
struct Share {
    DoublePair value;
    double error;
};

// The point at `share` of the way from a to b, or nothing.
std::optional<double> rounded_between(double a, double b, const Share& share)
{
    const DoublePair way = sum(b, -a);
    const DoublePair value = DoublePair{a, 0} + share.value * way;
    const double error =
        std::abs(way.high) * (share.error + 0x1p-98) + 0x1p-100 * std::abs(a);
    return rounded(value, 1.001 * error);
}

}  // namespace

SectionPoint rounded_crossing(const SectionLine& p, const SectionLine& q)
{
    // With f the signed area above p, the crossing divides q as f(a) : -f(b).
    const DoublePair ds = sum(p.b[0], -p.a[0]);
    const DoublePair dz = sum(p.b[1], -p.a[1]);
    const DoublePair left_a = ds * sum(q.a[1], -p.a[1]);
    const DoublePair right_a = dz * sum(q.a[0], -p.a[0]);
    const DoublePair left_b = ds * sum(q.b[1], -p.a[1]);
    const DoublePair right_b = dz * sum(q.b[0], -p.a[0]);
    const DoublePair area = left_a - right_a;
    const DoublePair span = area - (left_b - right_b);
    const double doubt =
        0x1p-99 * std::max(std::abs(left_a.high) + std::abs(right_a.high),
                           std::abs(left_b.high) + std::abs(right_b.high)) +
        std::numeric_limits<double>::min();
    const Share share{area / span, 1.001 * doubt / std::abs(span.high)};
    const auto s = rounded_between(q.a[0], q.b[0], share);
    const auto z = rounded_between(q.a[1], q.b[1], share);
    if (s && z)
        return {*s, *z};
    const SectionPoint exact = exact_crossing(p, q);
    return {s.value_or(exact[0]), z.value_or(exact[1])};
}

double rounded_height(const SectionLine& line, double s)
{
    const DoublePair run = sum(line.b[0], -line.a[0]);
    const Share share{sum(s, -line.a[0]) / run,
                      std::numeric_limits<double>::min() / std::abs(run.high)};
    const auto z = rounded_between(line.a[1], line.b[1], share);
    return z ? *z : exact_height(line, s);
}

}  // namespace endmill
