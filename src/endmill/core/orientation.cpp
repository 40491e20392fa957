// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/orientation.h"

#include <initializer_list>
#include <limits>

#include <boost/multiprecision/cpp_int.hpp>

#include "endmill/core/detail/exact_arithmetic.h"

namespace endmill {
namespace {

int sign(double value)
{
    return (value > 0) - (value < 0);
}

// Adds the product of two exact pairs: four products of doubles, which are eight terms.
void add_product(ExactSum& sum, const ExactPair& a, const ExactPair& b)
{
    for (const double x : {a.rest, a.rounded})
        for (const double y : {b.rest, b.rounded})
            sum.add_product(x, y);
}

// Whether products of coordinates and their rounding errors are doubles. Both are
// multiples of the square of a coordinate's last bit, so coordinates of this range are
// safe.
bool is_of_middle_size(double coordinate)
{
    constexpr double smallest = 0x1p-484;
    constexpr double largest = 0x1p+509;
    const double size = std::abs(coordinate);
    return size == 0 || (smallest <= size && size <= largest);
}

// The coordinate as a multiple of the smallest double, 2^-1074.
boost::multiprecision::cpp_int integer(double coordinate)
{
    constexpr int digits = 53;
    constexpr int smallest_exponent = -1074;
    int exponent = 0;
    const double fraction = std::frexp(coordinate, &exponent);
    exponent -= digits + smallest_exponent;
    boost::multiprecision::cpp_int result{
        static_cast<long long>(std::ldexp(fraction, digits))};
    if (exponent >= 0)
        result <<= exponent;
    else
        result >>= -exponent;  // of a denormal number: the bits shifted out are 0
    return result;
}

// The predicate in integers of any length, for coordinates of any size.
int turn_by_integers(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                     const Eigen::Vector2d& other_from, const Eigen::Vector2d& other_to)
{
    const boost::multiprecision::cpp_int difference =
        (integer(to.x()) - integer(from.x())) *
            (integer(other_to.y()) - integer(other_from.y())) -
        (integer(to.y()) - integer(from.y())) *
            (integer(other_to.x()) - integer(other_from.x()));
    return difference.sign();
}

// Whether the components i and j of b - a and c - a are linearly independent.
//
// The determinant of the rounded differences decides if it exceeds Shewchuk's bound on
// its rounding error. Otherwise the determinant is expanded into six products of
// coordinates, which are summed without rounding.
bool are_independent(const Vec3& a, const Vec3& b, const Vec3& c, int i, int j)
{
    // ccwerrboundA of [Shewchuk, section 4]: rounding error of the determinant, as a
    // share of the sum of the sizes of its products.
    constexpr double unit = std::numeric_limits<double>::epsilon() / 2;
    constexpr double determinant_rounding = (3 + 16 * unit) * unit;
    // Added because a product below this size may have lost digits.
    constexpr double underflow = std::numeric_limits<double>::min();

    const double u = b[i] - a[i];
    const double v = b[j] - a[j];
    const double s = c[i] - a[i];
    const double t = c[j] - a[j];
    const double left = u * t;
    const double right = v * s;
    if (std::abs(left - right) >
        determinant_rounding * (std::abs(left) + std::abs(right)) + underflow)
        return true;
    // A rounded difference is zero only if the exact one is, so both products vanish.
    if ((u == 0 || t == 0) && (v == 0 || s == 0))
        return false;
    ExactSum determinant;
    determinant.add_product(b[i], c[j]);
    determinant.add_product(-b[j], c[i]);
    determinant.add_product(a[j], c[i]);
    determinant.add_product(-a[i], c[j]);
    determinant.add_product(a[i], b[j]);
    determinant.add_product(-a[j], b[i]);
    return determinant.sign() != 0;
}

}  // namespace

// The predicate is decided in up to three steps, each more expensive than the one before:
// 1. by the signs of the rounded differences, which are the true signs;
// 2. by the exact sum of the 16 products of the differences and their rounding errors;
// 3. in integers, if a coordinate is so large or small that such a product leaves the
//    range of a double.
int exact_turn(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
               const Eigen::Vector2d& other_from, const Eigen::Vector2d& other_to)
{
    const int a = sign(to.x() - from.x()) * sign(other_to.y() - other_from.y());
    const int b = sign(to.y() - from.y()) * sign(other_to.x() - other_from.x());
    if (a != b)
        return a > b ? 1 : -1;
    if (a == 0)
        return 0;

    for (const Eigen::Vector2d* point : {&from, &to, &other_from, &other_to}) {
        if (!is_of_middle_size(point->x()) || !is_of_middle_size(point->y()))
            return turn_by_integers(from, to, other_from, other_to);
    }
    ExactSum sum;
    add_product(sum, two_sum(to.x(), -from.x()), two_sum(other_to.y(), -other_from.y()));
    add_product(sum, two_sum(from.y(), -to.y()), two_sum(other_to.x(), -other_from.x()));
    return sum.sign();
}

bool are_collinear(const Vec3& a, const Vec3& b, const Vec3& c)
{
    return !are_independent(a, b, c, 0, 1) && !are_independent(a, b, c, 1, 2) &&
           !are_independent(a, b, c, 2, 0);
}

}  // namespace endmill
