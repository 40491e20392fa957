// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/exact_crossing.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <limits>
#include <utility>

#include <boost/multiprecision/cpp_int.hpp>

namespace endmill {
namespace {

// 512 bits without allocation, which is enough for coordinates of similar size.
// How a decision becomes exact:
// 1. Every double is an integer times a power of two. The Frame of a decision is the
//    smallest such power among its coordinates, so that all of them are integers in that
//    unit.
// 2. A line becomes three integers (HomogeneousLine), and a crossing of two lines their
//    cross product (HomogeneousPoint). No division occurs.
// 3. The decision is the sign of a polynomial in these integers.
// 4. A rounded coordinate is the quotient of two integers, computed with more bits than a
//    double has and then rounded once (nearest).
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<512>,
                                              boost::multiprecision::et_off>;

constexpr int mantissa_bits = std::numeric_limits<double>::digits;
constexpr int least_exponent = -1074;  // exponent of the last bit of the smallest double

// value = mantissa * 2^exponent, with an odd mantissa, or 0.
struct Binary {
    std::int64_t mantissa;
    int exponent;
};

Binary binary(double value)
{
    if (value == 0)
        return {0, std::numeric_limits<int>::max()};
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(fraction, mantissa_bits));
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
    return {mantissa / (std::int64_t{1} << zeros), exponent - mantissa_bits + zeros};
}

// The point (s, z) / w with w > 0, in units of the frame.
struct HomogeneousPoint {
    Integer s;
    Integer z;
    Integer w;
};

// A point lies above the line if s * point.s + z * point.z + w * point.w > 0. z is
// positive.
struct HomogeneousLine {
    Integer s;
    Integer z;
    Integer w;
};

// The unit of length of a decision, 2^exponent. All coordinates of the decision are
// multiples of it.
class Frame {
public:
    Frame(std::initializer_list<const SectionLine*> lines,
          std::initializer_list<double> more)
        : exponent_{std::numeric_limits<int>::max()}
    {
        for (const SectionLine* line : lines) {
            for (const SectionPoint& point : {line->a, line->b}) {
                add(point[0]);
                add(point[1]);
            }
        }
        for (const double value : more)
            add(value);
    }

    int exponent() const { return exponent_; }

    Integer integer(double value) const
    {
        const auto [mantissa, exponent] = binary(value);
        Integer result{mantissa};
        if (mantissa != 0)
            result <<= exponent - exponent_;
        return result;
    }

    HomogeneousLine line(const SectionLine& line) const
    {
        const bool is_forward = line.a[0] < line.b[0];
        const SectionPoint& left = is_forward ? line.a : line.b;
        const SectionPoint& right = is_forward ? line.b : line.a;
        const Integer s = integer(left[0]);
        const Integer z = integer(left[1]);
        const Integer ds = integer(right[0]) - s;
        const Integer dz = integer(right[1]) - z;
        return {-dz, ds, dz * s - ds * z};
    }

private:
    void add(double value) { exponent_ = std::min(exponent_, binary(value).exponent); }

    int exponent_;
};

HomogeneousPoint crossing(const HomogeneousLine& p, const HomogeneousLine& q)
{
    HomogeneousPoint point{p.z * q.w - q.z * p.w, p.w * q.s - q.w * p.s,
                           p.s * q.z - q.s * p.z};
    if (point.w.sign() < 0) {
        point.s = -point.s;
        point.z = -point.z;
        point.w = -point.w;
    }
    return point;
}

HomogeneousPoint point_at(const HomogeneousLine& line, const Integer& s)
{
    return {s * line.z, -(line.s * s + line.w), line.z};
}

int side(const HomogeneousLine& line, const HomogeneousPoint& point)
{
    return Integer{line.s * point.s + line.z * point.z + line.w * point.w}.sign();
}

// The double nearest to numerator / denominator * 2^exponent, ties to even.
double nearest(Integer numerator, Integer denominator, int exponent)
{
    const int sign = numerator.sign();
    if (sign == 0)
        return 0;
    numerator = abs(numerator);
    // The quotient has two or three bits more than a double. The remainder only decides
    // ties.
    const int shift = mantissa_bits + 2 + static_cast<int>(msb(denominator)) -
                      static_cast<int>(msb(numerator));
    if (shift >= 0)
        numerator <<= shift;
    else
        denominator <<= -shift;
    Integer quotient;
    Integer rest;
    divide_qr(numerator, denominator, quotient, rest);
    const auto bits = static_cast<std::uint64_t>(quotient);
    const int last = exponent - shift;  // exponent of the last of these bits
    const int kept_last = std::max(
        least_exponent, last + static_cast<int>(std::bit_width(bits)) - mantissa_bits);
    const int dropped = kept_last - last;
    if (dropped > static_cast<int>(std::bit_width(bits)))
        return 0;  // less than half of the smallest double
    const std::uint64_t half = std::uint64_t{1} << (dropped - 1);
    const std::uint64_t tail = bits & (2 * half - 1);
    std::uint64_t kept = dropped < 64 ? bits >> dropped : 0;
    if (tail > half || (tail == half && (!rest.is_zero() || kept % 2 == 1)))
        ++kept;
    return sign * std::ldexp(static_cast<double>(kept), kept_last);
}

}  // namespace

int exact_side(const SectionLine& line, const SectionLine& p, const SectionLine& q)
{
    const Frame frame{{&line, &p, &q}, {}};
    return side(frame.line(line), crossing(frame.line(p), frame.line(q)));
}

int exact_height_order(const SectionLine& p, const SectionLine& q, double s)
{
    const Frame frame{{&p, &q}, {s}};
    return side(frame.line(q), point_at(frame.line(p), frame.integer(s)));
}

int exact_order(const SectionLine& p, const SectionLine& q, double s)
{
    const Frame frame{{&p, &q}, {s}};
    const HomogeneousPoint x = crossing(frame.line(p), frame.line(q));
    return Integer{x.s - frame.integer(s) * x.w}.sign();
}

int exact_order(const SectionLine& p1, const SectionLine& q1, const SectionLine& p2,
                const SectionLine& q2)
{
    const Frame frame{{&p1, &q1, &p2, &q2}, {}};
    const HomogeneousPoint x = crossing(frame.line(p1), frame.line(q1));
    const HomogeneousPoint y = crossing(frame.line(p2), frame.line(q2));
    return Integer{x.s * y.w - y.s * x.w}.sign();
}

SectionPoint exact_crossing(const SectionLine& p, const SectionLine& q)
{
    const Frame frame{{&p, &q}, {}};
    const HomogeneousPoint x = crossing(frame.line(p), frame.line(q));
    return {nearest(x.s, x.w, frame.exponent()), nearest(x.z, x.w, frame.exponent())};
}

double exact_height(const SectionLine& line, double s)
{
    const Frame frame{{&line}, {s}};
    const HomogeneousPoint x = point_at(frame.line(line), frame.integer(s));
    return nearest(x.z, x.w, frame.exponent());
}

}  // namespace endmill
