// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/straight_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "random.h"

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// S without its closed forms: the least over densely sampled positions, refined by golden
// section.
double least_over_positions(const Cutter& cutter, const Vec3& from, const Vec3& to,
                            double x, double y)
{
    const auto height = [&](double share) {
        const Vec3 tip = from + share * (to - from);
        return tip.z() + cutter.profile(std::hypot(x - tip.x(), y - tip.y()));
    };
    constexpr int steps = 2000;
    int best = 0;
    for (int i = 1; i <= steps; ++i)
        if (height(i / double(steps)) < height(best / double(steps)))
            best = i;
    double low = std::max(0, best - 1) / double(steps);
    double high = std::min(steps, best + 1) / double(steps);
    double least = height(best / double(steps));
    for (int i = 0; i < 60; ++i) {
        const double a = low + 0.382 * (high - low);
        const double b = low + 0.618 * (high - low);
        least = std::min({least, height(a), height(b)});
        (height(a) < height(b) ? high : low) = height(a) < height(b) ? b : a;
    }
    return least;
}

class StraightSweepOf : public testing::TestWithParam<Cutter> {};

TEST_P(StraightSweepOf, IsTheLeastOverAllPositions)
{
    const Cutter cutter = GetParam();
    test::Random random{7};
    for (int i = 0; i < 300; ++i) {
        const Vec3 from{random.uniform(-5, 5), random.uniform(-5, 5),
                        random.uniform(-5, 5)};
        const Vec3 to = from + Vec3{random.uniform(-9, 9), random.uniform(-9, 9),
                                    random.uniform(-9, 9)};
        const double x = random.uniform(-12, 12);
        const double y = random.uniform(-12, 12);
        const double expected = least_over_positions(cutter, from, to, x, y);
        const double found = StraightSweep{cutter, from, to}.height(x, y);
        if (std::isinf(expected)) {
            // All sampled positions may miss a place that the sweep grazes.
            continue;
        }
        EXPECT_LE(found, expected + 1e-12);
        // At the steep rim the sampled positions leave an error.
        EXPECT_GE(found, expected - (cutter.is_flat() ? 2e-2 : 1e-4)) << i;
    }
}

// A move, and a place above it or near it.
struct PlacedMove {
    Vec3 from;
    Vec3 to;
    double x;
    double y;
};

PlacedMove random_move(test::Random& random)
{
    const auto near = [&](double most) { return random.uniform(-most, most); };
    return {{near(5), near(5), 0}, {near(5), near(5), near(5)}, near(9), near(9)};
}

TEST_P(StraightSweepOf, IsTheSameBackwards)
{
    test::Random random{8};
    for (int i = 0; i < 300; ++i) {
        const auto [from, to, x, y] = random_move(random);
        const double forwards = StraightSweep{GetParam(), from, to}.height(x, y);
        const double backwards = StraightSweep{GetParam(), to, from}.height(x, y);
        if (std::isinf(forwards)) {
            EXPECT_EQ(forwards, backwards);
        } else {
            EXPECT_NEAR(forwards, backwards, 1e-11);
        }
    }
}

TEST_P(StraightSweepOf, IsTheLeastOfItsPieces)
{
    test::Random random{9};
    for (int i = 0; i < 300; ++i) {
        const auto [from, to, x, y] = random_move(random);
        const double whole = StraightSweep{GetParam(), from, to}.height(x, y);
        double pieces = infinite;
        for (int k = 0; k < 7; ++k)
            pieces =
                std::min(pieces, StraightSweep{GetParam(), from + k / 7.0 * (to - from),
                                               from + (k + 1) / 7.0 * (to - from)}
                                     .height(x, y));
        if (std::isfinite(whole) && std::isfinite(pieces)) {
            EXPECT_NEAR(whole, pieces, 1e-11);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(BallFlatBull, StraightSweepOf,
                         testing::Values(Cutter::ball(5), Cutter::flat(5), Cutter{5, 2},
                                         Cutter{5, 0.01}, Cutter{5, 4.99}));

TEST(StraightSweep, StraightDownIsTheCutterAtItsLowerEnd)
{
    const StraightSweep plunge{Cutter::ball(5), {1, 2, 9}, {1, 2, -3}};
    EXPECT_EQ(plunge.height(1, 2), -3);
    EXPECT_NEAR(plunge.height(4, 2), -3 + 5 - 4, 1e-15 * 5);
    EXPECT_EQ(plunge.height(6.1, 2), infinite);
}

TEST(StraightSweep, OfALevelBallIsACylinder)
{
    const StraightSweep level{Cutter::ball(5), {0, 0, 1}, {10, 0, 1}};
    EXPECT_NEAR(level.height(5, 3), 1 + 5 - 4, 1e-14);
    EXPECT_NEAR(level.height(-3, 0), 1 + 5 - 4, 1e-14);
    EXPECT_EQ(level.height(5, 5.01), infinite);
    EXPECT_EQ(level.height(-5.01, 0), infinite);
}

// Uphill at 45 degrees the underside of the ball is R below its axis, measured
// perpendicularly.
TEST(StraightSweep, OfABallUphillIsACylinderAcross)
{
    const StraightSweep uphill{Cutter::ball(5), {0, 0, 0}, {20, 0, 20}};
    EXPECT_NEAR(uphill.height(10, 0), 10 + 5 - 5 * std::sqrt(2.0), 1e-13);
}

TEST(StraightSweep, RefusesTipsThatAreNotFinite)
{
    EXPECT_THROW(StraightSweep(Cutter::ball(1), {0, 0, infinite}, {0, 0, 0}),
                 DomainError);
}

}  // namespace
}  // namespace endmill
