// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/near_contact.h"

#include <cmath>

#include <gtest/gtest.h>

namespace endmill {
namespace {

// A contact on the parabolic cylinder z = x^2 / 20.
CutterContact on_parabola(double x)
{
    return {{x, 0, x * x / 20}, Vec3{-x / 10, 0, 1}.normalized()};
}

// The distance from the parabola of a place between two contacts.
double error_between(double from, double to)
{
    const CutterContact near = near_contact(on_parabola(from), on_parabola(to), 0.3);
    EXPECT_NEAR(near.normal.norm(), 1, 1e-12);
    return std::abs(near.point.z() - near.point.x() * near.point.x() / 20);
}

TEST(NearContact, FollowsTheCurvature)
{
    const double chord = 0.3 * 0.7 * 4 / 20;  // error of the chord from 1 to 3
    EXPECT_LT(error_between(1, 3), 0.1 * chord);
    EXPECT_LT(error_between(1, 2), error_between(1, 3) / 6);
}

TEST(NearContact, IsExactAtItsEnds)
{
    const CutterContact from = on_parabola(1);
    const CutterContact to = on_parabola(3);
    EXPECT_LT((near_contact(from, to, 0).point - from.point).norm(), 1e-15);
    EXPECT_LT((near_contact(from, to, 1).point - to.point).norm(), 1e-15);
    EXPECT_LT((near_contact(from, to, 1).normal - to.normal).norm(), 1e-15);
}

}  // namespace
}  // namespace endmill
