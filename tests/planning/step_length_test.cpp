// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/step_length.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "endmill/core/error.h"
#include "random.h"

namespace endmill {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double error_of(double found, const Real& expected)
{
    return static_cast<double>(abs((Real{found} - expected) / expected));
}

struct StepVector {
    double rho;
    double delta;
    double chord;
    double projected;
};

// Vectors computed with 50 digits.
TEST(StepLength, IsTheTabulatedOne)
{
    for (const auto& [rho, delta, chord, projected] :
         {StepVector{100, 0.5, 19.9749843554382, 19.8751094336610},
          {100, 1, 28.2134719593318, 27.9313372397385},
          {50, 0.2, 8.93532316147547, 8.89958186882957},
          {1000, 0.01, 8.94424954929143, 8.94416010679594},
          {1, 0.25, 1.32287565553230, 0.992156741649221},
          {1e7, 0.001, 282.842712467548, 282.842712439264}}) {
        const StepLength step = step_length(1 / rho, delta);
        EXPECT_LT(test::relative_error(step.chord, chord), 1e-14) << rho;
        EXPECT_LT(test::relative_error(step.projected, projected), 1e-14) << rho;
        EXPECT_EQ(step.status, LengthStatus::Ok);
    }
}

TEST(StepLength, IsTheTabulatedOneAtAndBeyondItsLimit)
{
    const StepLength at_limit = step_length(1 / 2.0, 0.5857864376269049);
    EXPECT_LT(test::relative_error(at_limit.chord, 2.82842712474619), 1e-14);
    EXPECT_LT(test::relative_error(at_limit.projected, 2), 1e-14);
    for (const auto& [rho, delta, chord, projected] :
         {StepVector{0.6, 0.5, 0.848528137423857, 0.6},
          {0.3, 0.5, 0.424264068711929, 0.3},
          {1e-3, 1e3, std::numbers::sqrt2 * 1e-3, 1e-3}}) {
        const StepLength step = step_length(1 / rho, delta);
        EXPECT_LT(test::relative_error(step.chord, chord), 1e-14) << rho;
        EXPECT_LT(test::relative_error(step.projected, projected), 1e-14) << rho;
        EXPECT_EQ(step.half_angle.radians(), std::numbers::pi / 4);
        EXPECT_EQ(step.status, LengthStatus::Clamped);
    }
}

// The step on a circle: theta = acos(1 - delta / rho), L = 2 rho sin(theta), D = rho
// sin(2 theta). [KimChoi, eq. (1), (2)]
TEST(StepLength, KeepsTheAccuracyItStates)
{
    test::Random random{1};
    double worst = 0;
    for (int n = 0; n < 2000; ++n) {
        const double k = random.log_uniform(1e-9, 1e3);
        const double delta = random.log_uniform(1e-9, 0.2928) / k;
        const StepLength step = step_length(k, delta);
        const Real theta = acos(1 - Real{k} * Real{delta});
        worst = std::max({worst, error_of(step.chord, 2 * sin(theta) / k),
                          error_of(step.projected, sin(2 * theta) / k),
                          error_of(step.half_angle.radians(), theta)});
    }
    EXPECT_LT(worst, 1e-14);
}

TEST(StepLength, SagittaOfTheChordIsTheTolerance)
{
    for (const double k : {1e-6, 1e-3, 0.1, 0.5})
        for (const double delta : {1e-4, 0.01, 0.5}) {
            const double half = step_length(k, delta).chord / 2;
            const double sagitta =
                k * half * half / (1 + std::sqrt(1 - k * k * half * half));
            EXPECT_LT(test::relative_error(sagitta, delta), 1e-14);
        }
}

TEST(StepLength, DoesNotJumpWhereItIsClamped)
{
    const double limit = 1 - std::numbers::sqrt2 / 2;
    const StepLength below = step_length(1, limit * (1 - 1e-12));
    const StepLength above = step_length(1, limit * (1 + 1e-12));
    EXPECT_EQ(below.status, LengthStatus::Ok);
    EXPECT_EQ(above.status, LengthStatus::Clamped);
    EXPECT_NEAR(below.chord, above.chord, 1e-11);
    EXPECT_NEAR(below.projected, above.projected, 1e-11);
    EXPECT_NEAR(below.half_angle.radians(), above.half_angle.radians(), 1e-11);
}

TEST(StepLength, GrowsWithTheToleranceAndShrinksWithTheCurvature)
{
    double last_chord = 0;
    double last_projected = 0;
    for (double delta = 1e-3; delta < 2; delta *= 1.1) {
        const StepLength step = step_length(0.2, delta);
        EXPECT_GE(step.chord, last_chord);
        EXPECT_GE(step.projected, last_projected);
        EXPECT_LE(step_length(0.3, delta).chord, step.chord);
        last_chord = step.chord;
        last_projected = step.projected;
    }
}

TEST(StepLength, IsUnlimitedOnAStraightLine)
{
    for (const double k : {0.0, -0.0, 1e-310}) {
        const StepLength step = step_length(k, 0.5);
        EXPECT_EQ(step.status, LengthStatus::Unlimited);
        EXPECT_EQ(step.chord, infinity);
        EXPECT_EQ(step.projected, infinity);
        EXPECT_EQ(step.half_angle.radians(), 0);
    }
}

TEST(StepLength, DoesNotDependOnTheSignOfTheCurvature)
{
    for (const double k : {1e-5, 0.1, 3.0})
        EXPECT_EQ(step_length(-k, 0.3).projected, step_length(k, 0.3).projected);
}

TEST(StepLength, ScalesExactlyWithPowersOfTwo)
{
    const StepLength step = step_length(0.013, 0.07);
    const StepLength scaled = step_length(0.013 * 0x1p-9, 0.07 * 0x1p9);
    EXPECT_EQ(scaled.chord, 0x1p9 * step.chord);
    EXPECT_EQ(scaled.half_angle.radians(), step.half_angle.radians());
}

TEST(StepLength, RefusesArgumentsOutsideItsDomain)
{
    for (const double delta : {0.0, -1.0, infinity, nan})
        EXPECT_THROW(step_length(0.1, delta), DomainError) << delta;
    for (const double k : {infinity, -infinity, nan})
        EXPECT_THROW(step_length(k, 0.1), DomainError) << k;
}

TEST(LengthStatus, HasNames)
{
    EXPECT_EQ(length_status_name(LengthStatus::Ok), "ok");
    EXPECT_EQ(length_status_name(LengthStatus::Clamped), "clamped");
    EXPECT_EQ(length_status_name(LengthStatus::Unlimited), "unlimited");
}

}  // namespace
}  // namespace endmill
