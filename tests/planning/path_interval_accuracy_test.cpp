// SPDX-License-Identifier: GPL-3.0-or-later
// The accuracies that path_interval.h states, compared with 50 digits.
#include <algorithm>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "endmill/planning/path_interval.h"
#include "random.h"

namespace endmill {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;

double error_of(double found, const Real& expected)
{
    return static_cast<double>(abs((Real{found} - expected) / expected));
}

// The triangle of the circle's centre, a ball's centre and the peak, solved directly.
// [KimChoi, eq. (14)]
Real half_angle(const Real& R, const Real& rho, const Real& h)
{
    const Real a = rho + R;
    const Real b = rho + h;
    return acos((a * a + b * b - R * R) / (2 * a * b));
}

// Greatest relative error of `interval`; `alpha` is its half angle.
double worst_error(const PathInterval& interval, const Real& rho, const Real& alpha)
{
    return std::max({error_of(interval.chord, 2 * abs(rho) * sin(alpha)),
                     error_of(interval.projected, abs(rho) * sin(2 * alpha)),
                     error_of(interval.arc, 2 * abs(rho) * alpha),
                     error_of(interval.half_angle.radians(), alpha)});
}

// Random k R between -0.99 and 1000. Half of them are concave, and a quarter approach -1,
// where the ball barely fits.
double random_relative_curvature(test::Random& random)
{
    if (random.uniform(0, 1) < 0.5)
        return random.log_uniform(1e-9, 1e3);
    return random.uniform(0, 1) < 0.5 ? -random.log_uniform(1e-9, 0.99)
                                      : -1 + random.log_uniform(0.01, 1);
}

TEST(PathIntervalAccuracy, IsTheStatedOne)
{
    test::Random random{1};
    double worst = 0;
    int count = 0;
    for (int n = 0; n < 3000; ++n) {
        const double R = random.log_uniform(1e-2, 1e2);
        const double k = random_relative_curvature(random) / R;
        const double h = R * random.log_uniform(1e-9, 1.99);
        if (1 + k * R <= 0.01 || 1 + k * h <= 0.01)
            continue;
        const PathInterval interval = path_interval(BallCutter{R}, k, h);
        if (interval.status != LengthStatus::Ok)
            continue;
        ++count;
        const Real rho = 1 / Real{k};
        worst = std::max(worst, worst_error(interval, rho, half_angle(R, rho, h)));
    }
    EXPECT_GT(count, 1500);
    EXPECT_LT(worst, 1e-14);
}

TEST(PathIntervalAccuracy, IsTheStatedOneWhereTheScallopIsClamped)
{
    test::Random random{2};
    double worst = 0;
    int count = 0;
    for (int n = 0; n < 2000; ++n) {
        const double R = random.log_uniform(1e-2, 1e2);
        const double k = random.uniform(-0.29, 2.41) / R;  // alpha stays below 45 degrees
        const double h = R * random.uniform(0.5, 1.99);
        const PathInterval interval = path_interval(BallCutter{R}, k, h);
        if (interval.status != LengthStatus::Clamped)
            continue;
        ++count;
        const Real rho = 1 / Real{k};
        worst = std::max(worst, worst_error(interval, rho, asin(R / abs(R + rho))));
    }
    EXPECT_GT(count, 500);
    EXPECT_LT(worst, 1e-14);
}

// The point of the bisector at distance R from a ball centre.
Real scallop(const Real& R, const Real& rho, const Real& l)
{
    const Real sine = l / (2 * rho);
    const Real across = (rho + R) * sine;
    return (rho + R) * sqrt(1 - sine * sine) - sqrt(R * R - across * across) - rho;
}

// Where the balls barely meet, the scallop depends so steeply on the interval that the
// rounding of the interval dominates its error.
TEST(ScallopHeightAccuracy, IsTheStatedOneBelowTheHighestScallop)
{
    test::Random random{3};
    double worst = 0;
    for (int n = 0; n < 3000; ++n) {
        const double R = random.log_uniform(1e-2, 1e2);
        const double k = random_relative_curvature(random) / R;
        const double longest = std::min(2 / std::abs(k), 2 * R / (1 + k * R));
        const double l = longest * random.log_uniform(1e-6 * R / longest, 0.99);
        worst = std::max(worst, error_of(scallop_height(BallCutter{R}, k, l),
                                         scallop(R, 1 / Real{k}, l)));
    }
    EXPECT_LT(worst, 1e-13);
}

}  // namespace
}  // namespace endmill
