// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/orientation.h"

#include <limits>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_int.hpp>

#include "random.h"

namespace endmill {
namespace {

using Eigen::Vector2d;
using Rational = boost::multiprecision::cpp_rational;

// The side, computed with fractions.
int expected_side(const Vector2d& p, const Vector2d& q, const Vector2d& r)
{
    const Rational x{p.x()};
    const Rational y{p.y()};
    const Rational cross{(Rational{q.x()} - x) * (Rational{r.y()} - y) -
                         (Rational{q.y()} - y) * (Rational{r.x()} - x)};
    return cross.sign();
}

// Compares with fractions, and checks the identities for all orders of the points.
void expect_side(const Vector2d& p, const Vector2d& q, const Vector2d& r)
{
    const int side = expected_side(p, q, r);
    EXPECT_EQ(orientation(p, q, r), side);
    EXPECT_EQ(exact_turn(p, q, p, r), side);
    EXPECT_EQ(turn(p, q, q, r), side);
    EXPECT_EQ(orientation(q, r, p), side);
    EXPECT_EQ(orientation(q, p, r), -side);
    EXPECT_EQ(orientation(p, r, q), -side);
}

TEST(Orientation, IsPositiveOnTheLeft)
{
    EXPECT_EQ(orientation({0, 0}, {1, 0}, {0, 1}), 1);
    EXPECT_EQ(orientation({0, 0}, {1, 0}, {0, -1}), -1);
    EXPECT_EQ(orientation({0, 0}, {1, 0}, {5, 0}), 0);
    EXPECT_EQ(orientation({2, 3}, {2, 3}, {5, 0}), 0);
}

TEST(Turn, IsThatOfFractionsForNearlyParallelSegments)
{
    test::Random random{13};
    const auto number = [&] { return random.uniform(-9, 9); };
    for (int k = 0; k < 2000; ++k) {
        const Vector2d from{number(), number()};
        const Vector2d to{number(), number()};
        const Vector2d other{number(), number()};
        const Vector2d other_to = other + number() * (to - from);
        const Rational cross{(Rational{to.x()} - Rational{from.x()}) *
                                 (Rational{other_to.y()} - Rational{other.y()}) -
                             (Rational{to.y()} - Rational{from.y()}) *
                                 (Rational{other_to.x()} - Rational{other.x()})};
        EXPECT_EQ(turn(from, to, other, other_to), cross.sign());
        EXPECT_EQ(turn(other, other_to, from, to), -cross.sign());
    }
    EXPECT_EQ(turn({0, 0}, {3, 1}, {5, 5}, {11, 7}), 0);
    EXPECT_EQ(turn({0, 0}, {3, 1}, {5, 5}, {5, 5}), 0);
}

TEST(Orientation, IsThatOfFractionsWhereAPointIsNextToTheLine)
{
    test::Random random{3};
    for (int k = 0; k < 3000; ++k) {
        const Vector2d p{random.uniform(-1, 1), random.uniform(-1, 1)};
        const Vector2d q{random.uniform(-1, 1), random.uniform(-1, 1)};
        const Vector2d on_line = p + random.uniform(-20, 20) * (q - p);
        expect_side(p, q, on_line);
        expect_side(p, q, {std::nextafter(on_line.x(), 30), on_line.y()});
        expect_side(p, q, {on_line.x(), std::nextafter(on_line.y(), -30)});
    }
}

TEST(Orientation, IsThatOfFractionsOnAGrid)
{
    test::Random random{5};
    const auto number = [&] { return std::floor(random.uniform(-4, 5)) * 0.1; };
    for (int k = 0; k < 3000; ++k)
        expect_side({number(), number()}, {number(), number()}, {number(), number()});
}

TEST(Orientation, IsThatOfFractionsForAllSizesOfNumbers)
{
    test::Random random{11};
    const auto number = [&] {
        const double size = std::ldexp(random.uniform(0.5, 1),
                                       static_cast<int>(random.uniform(-1100, 1024)));
        return random.uniform(-1, 1) < 0 ? -size : size;
    };
    for (int k = 0; k < 1000; ++k) {
        expect_side({number(), number()}, {number(), number()}, {number(), number()});
        const double size = number();
        expect_side({0, 0}, {size, 2 * size}, {3 * size, 6 * size});
        expect_side({size, size}, {-size, 2 * size}, {size, -size});
    }
}

TEST(Orientation, HoldsForTheSmallestAndTheLargestNumbers)
{
    const double least = std::numeric_limits<double>::denorm_min();
    const double most = std::numeric_limits<double>::max();
    expect_side({0, 0}, {least, least}, {2 * least, 3 * least});
    expect_side({0, 0}, {least, least}, {2 * least, 2 * least});
    expect_side({-most, -most}, {most, most}, {most, std::nextafter(most, 0)});
    expect_side({-most, -most}, {most, most}, {0, 0});
    expect_side({-most, -most}, {most, most}, {0, least});
    expect_side({1, 1}, {1 + least, 1}, {1, 1 + least});
}

}  // namespace
}  // namespace endmill
