// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/detail/ball_path_stock.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace endmill {
namespace {

constexpr int samples = 20'000;
constexpr double R = 10;
constexpr double valley_radius = 25;  // mm
constexpr double rounding = 1e-13;    // mm

// The best sample is within half an interval of the exact place, where the outline has
// the curvature 1 / r. The hundredth covers terms of higher order.
double excess_on_plane(const Cutter& cutter, double slope)
{
    if (cutter.is_flat())
        return rounding;
    const double interval = R / samples / std::cos(slope);
    return 1.01 * interval * interval / (2 * cutter.corner_radius()) + rounding;
}

// The best place on the circle is within half an interval of pi / samples.
double excess_in_valley(const Cutter& cutter, double slope)
{
    const double angle = std::numbers::pi / (2 * samples);
    return excess_on_plane(cutter, slope) + (valley_radius - R) * angle * angle / 2;
}

// The extent of a cutter from its reference point against a normal of slope a is that of
// the disc of radius R - r, which is (R - r) sin a, and of the corner, which is r. The
// ball's is R.
double stock_of_extent(const Cutter& cutter, double slope)
{
    return R - cutter.corner_radius() - cutter.flat_radius() * std::sin(slope);
}

// With equal tips, the reference point is R - r lower than the ball's centre.
double stock_of_tips(const Cutter& cutter, double slope)
{
    return stock_of_extent(cutter, slope) - cutter.flat_radius() * std::cos(slope);
}

class BallPathStock : public testing::TestWithParam<double> {
protected:
    // Tests both parts against the exact stock of each of them.
    void expect_stock(const Cutter& cutter, ControlPoint equated, double exact) const
    {
        const double plane = stock_on_plane(cutter, equated, slope, samples) - exact;
        EXPECT_GE(plane, -rounding);
        EXPECT_LE(plane, excess_on_plane(cutter, angle));
        const double valley =
            stock_in_valley(cutter, equated, slope, valley_radius, samples) - exact;
        EXPECT_GE(valley, -rounding);
        EXPECT_LE(valley, excess_in_valley(cutter, angle));
    }

    const Angle slope = Angle::degrees(GetParam());
    const double angle = slope.radians();
};

TEST_P(BallPathStock, IsTheDifferenceOfTheExtentsOfBothCutters)
{
    for (const Cutter& cutter : {Cutter::flat(R), Cutter{R, 3}, Cutter{R, 8}}) {
        expect_stock(cutter, ControlPoint::Reference, stock_of_extent(cutter, angle));
        expect_stock(cutter, ControlPoint::Tip, stock_of_tips(cutter, angle));
    }
}

TEST_P(BallPathStock, IsZeroForTheBallItself)
{
    for (const ControlPoint equated : {ControlPoint::Reference, ControlPoint::Tip})
        expect_stock(Cutter::ball(R), equated, 0);
}

INSTANTIATE_TEST_SUITE_P(Slopes, BallPathStock,
                         testing::Values(0.0, 10.0, 30.0, 45.0, 60.0));

}  // namespace
}  // namespace endmill
