// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/orientation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>

#include <boost/multiprecision/cpp_int.hpp>

#include "endmill/core/detail/exact_pair.h"

namespace endmill {
namespace {

int sign(double value)
{
    return (value > 0) - (value < 0);
}

// A sum of doubles kept exactly: as parts that do not overlap, smallest first.
// Source: Shewchuk, Adaptive precision floating-point arithmetic (1997), theorem 10.
class ExactSum {
public:
    void add(double term)
    {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            const ExactPair next = exact_sum(term, parts_[i]);
            if (next.rest != 0)
                parts_[kept++] = next.rest;
            term = next.rounded;
        }
        if (term != 0)
            parts_[kept++] = term;
        count_ = kept;
    }

    // The largest part outweighs all others.
    int sign() const { return count_ == 0 ? 0 : endmill::sign(parts_[count_ - 1]); }

private:
    std::array<double, 16> parts_{};  // one for each of the terms of two products
    std::size_t count_ = 0;
};

void add_product(ExactSum& sum, const ExactPair& a, const ExactPair& b)
{
    for (const double x : {a.rest, a.rounded}) {
        for (const double y : {b.rest, b.rounded}) {
            const ExactPair product = exact_product(x, y);
            sum.add(product.rest);
            sum.add(product.rounded);
        }
    }
}

// Whether the products of coordinates, and what their rounding loses, are doubles: those
// are multiples of the square of the coordinates' last bit.
bool is_of_middle_size(double coordinate)
{
    constexpr double smallest = 0x1p-484;
    constexpr double largest = 0x1p+509;
    const double size = std::abs(coordinate);
    return size == 0 || (smallest <= size && size <= largest);
}

// In units of the smallest double.
boost::multiprecision::cpp_int integer(double coordinate)
{
    constexpr int digits = 53;
    constexpr int smallest_exponent = -1074;  // of the last bit of a double
    int exponent = 0;
    const double fraction = std::frexp(coordinate, &exponent);
    exponent -= digits + smallest_exponent;
    boost::multiprecision::cpp_int result{
        static_cast<long long>(std::ldexp(fraction, digits))};
    if (exponent >= 0)
        result <<= exponent;
    else
        result >>= -exponent;  // the bits below the last are 0
    return result;
}

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

}  // namespace

int exact_turn(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
               const Eigen::Vector2d& other_from, const Eigen::Vector2d& other_to)
{
    // A rounded difference has the sign of the true one.
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
    add_product(sum, exact_sum(to.x(), -from.x()),
                exact_sum(other_to.y(), -other_from.y()));
    add_product(sum, exact_sum(from.y(), -to.y()),
                exact_sum(other_to.x(), -other_from.x()));
    return sum.sign();
}

}  // namespace endmill
