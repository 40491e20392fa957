// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/path_interval.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "random.h"

namespace endmill {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct IntervalVector {
    double R;
    double h;
    double rho;
    double alpha;
    double chord;
    double projected;
};

// Vectors computed with 50 digits.
TEST(PathInterval, IsTheTabulatedOne)
{
    for (const auto& [R, h, rho, alpha, chord, projected] :
         {IntervalVector{5, 1, infinity, 0, 6, 6},
          {7.5, 0.5, infinity, 0, 5.38516480713450, 5.38516480713450},
          {10, 0.2, infinity, 0, 3.97994974842648, 3.97994974842648},
          {5, 0.01, infinity, 0, 0.632139225171164, 0.632139225171164},
          {5, 5, infinity, 0, 10, 10},
          {5, 1, 100, 0.0291327362106368, 5.82572309614670, 5.82325107785979},
          {7.5, 0.5, 100, 0.0259056136528286, 5.18054324072646, 5.17880500453555},
          {10, 0.2, 50, 0.0362613445206531, 3.62533984594373, 3.62295665441154},
          {5, 0.5, 10, 0.173881661429618, 3.46013542553082, 3.40795878022520},
          {5, 0.01, 1e8, 3.16069604668039e-9, 0.632139209336077, 0.632139209336077},
          {3, 0.001, 0.5, 0.0584990041776965, 0.0584656446526929, 0.0583656345579477},
          {5, 1, -100, 0.0309356448067671, 6.18614214694507, 6.18318227031973},
          {7.5, 0.5, -100, 0.0280673139091598, 5.61272578742058, 5.61051515251857},
          {10, 0.2, -50, 0.0445901471618405, 4.45753723386799, 4.45310654926806},
          {5, 0.5, -10, 0.317560429291521, 6.24499799839840, 5.93274809847848},
          {5, 0.01, -1e8, 3.16069620503126e-9, 0.632139241006253, 0.632139241006253},
          {7.5, 0.02, -8, 0.274886027167488, 4.34299591786920, 4.17994308867200}}) {
        const PathInterval interval = path_interval(BallCutter{R}, 1 / rho, h);
        EXPECT_EQ(interval.status, LengthStatus::Ok) << rho;
        EXPECT_LT(test::relative_error(interval.chord, chord), 1e-14) << rho;
        EXPECT_LT(test::relative_error(interval.projected, projected), 1e-14) << rho;
        EXPECT_NEAR(interval.half_angle.radians(), alpha, 1e-14 * alpha) << rho;
        const double arc = std::isinf(rho) ? chord : 2 * std::abs(rho) * alpha;
        EXPECT_LT(test::relative_error(interval.arc, arc), 1e-14) << rho;
    }
}

struct ClampedVector {
    double R;
    double h;
    double rho;
    double half_angle;
    double chord;
    double projected;
    double arc;
};

// Vectors computed with 50 digits.
TEST(PathInterval, IsTheTabulatedOneWhereItIsClamped)
{
    constexpr double right = std::numbers::pi / 4;
    for (const auto& [R, h, rho, half_angle, chord, projected, arc] :
         {ClampedVector{10, 0.5, 1, right, 1.41421356237310, 1, 1.57079632679490},
          {5, 0.5, -6, right, 8.48528137423857, 6, 9.42477796076938},
          {5, 0.5, -5.3, right, 7.49533188057740, 5.3, 8.32522053201295},
          {5, 0.5, -5.2501, right, 7.42476262381499, 5.2501, 8.24683779530589},
          {5, 6, infinity, 0, 10, 10, 10},
          {5, 4.5, 10, 0.339836909454122, 6.66666666666667, 6.28539361054709,
           6.79673818908244}}) {
        const PathInterval interval = path_interval(BallCutter{R}, 1 / rho, h);
        EXPECT_EQ(interval.status, LengthStatus::Clamped) << rho;
        EXPECT_LT(test::relative_error(interval.chord, chord), 1e-14) << rho;
        EXPECT_LT(test::relative_error(interval.projected, projected), 1e-14) << rho;
        EXPECT_LT(test::relative_error(interval.arc, arc), 1e-14) << rho;
        EXPECT_NEAR(interval.half_angle.radians(), half_angle, 1e-14) << rho;
    }
}

TEST(PathInterval, IsUnlimitedWhereOneBallReachesTheWholeConcavity)
{
    const PathInterval interval = path_interval(BallCutter{5}, -1 / 5.2, 0.5);
    EXPECT_EQ(interval.status, LengthStatus::Unlimited);
    EXPECT_EQ(interval.chord, infinity);
    EXPECT_EQ(interval.projected, infinity);
    EXPECT_EQ(interval.arc, infinity);
    // The far side of the arc has the distance 2 (|rho| - R) from the ball.
    EXPECT_EQ(path_interval(BallCutter{5}, -1 / 5.2, 0.3999).status,
              LengthStatus::Clamped);
    EXPECT_EQ(path_interval(BallCutter{5}, -1 / 5.2, 0.4001).status,
              LengthStatus::Unlimited);
}

TEST(PathInterval, RefusesABallThatDoesNotFitAndNamesItsLimit)
{
    for (const double rho : {-5.0, -4.0}) {
        try {
            path_interval(BallCutter{5}, 1 / rho, 0.5);
            FAIL() << "expected a GeometryError";
        } catch (const GeometryError& error) {
            EXPECT_NE(
                std::string{error.what()}.find(rho == -5 ? "radius 5 mm, its limit"
                                                         : "radius 4 mm, its limit"),
                std::string::npos)
                << error.what();
        }
    }
}

TEST(PathInterval, RefusesArgumentsOutsideItsDomain)
{
    const BallCutter ball{5};
    for (const double h : {0.0, -0.1, 10.0, 11.0, infinity, nan})
        EXPECT_THROW(path_interval(ball, 0, h), DomainError) << h;
    for (const double k : {infinity, -infinity, nan})
        EXPECT_THROW(path_interval(ball, k, 0.1), DomainError) << k;
}

TEST(PathInterval, OnAPlaneIsTheChordOfTheBallAtScallopHeight)
{
    for (const double R : {0.1, 5.0, 80.0})
        for (const double share : {1e-9, 1e-3, 0.3, 0.999}) {
            const double h = share * R;
            const double expected = 2 * std::sqrt(2 * R * h - h * h);
            EXPECT_LT(
                test::relative_error(path_interval(BallCutter{R}, 0, h).chord, expected),
                1e-14);
        }
}

TEST(PathInterval, TendsToThePlaneFromEitherSide)
{
    const double plane = path_interval(BallCutter{5}, 0, 0.1).chord;
    double last = 1;
    for (double k = 1e-2; k > 1e-12; k /= 10) {
        const double convex = path_interval(BallCutter{5}, k, 0.1).chord;
        const double concave = path_interval(BallCutter{5}, -k, 0.1).chord;
        EXPECT_LT(convex, plane);
        EXPECT_GT(concave, plane);
        EXPECT_NEAR((convex + concave) / 2, plane, (last * last + 1e-15) * plane);
        last = 50 * k;
    }
}

// [KimChoi, eq. (4)] as printed, in double precision.
double printed_interval(double R, double rho, double h)
{
    const double a = R + rho;
    const double b = h + rho;
    const double brace = rho * rho + 2 * R * rho + b * b;
    return std::abs(rho) * std::sqrt(4 * a * a * b * b - brace * brace) / (a * b);
}

TEST(PathInterval, AtLargeRadiiKeepsTheDigitsThatThePrintedFormLoses)
{
    for (const double rho : {1e7, 1e8}) {
        // 2 sqrt(2Rh - h^2), except for a share of about (R + h) / (2 rho).
        const double expected =
            0.632139225171164 * (1 - 5.01 / (2 * rho));  // second terms are below 1e-13
        EXPECT_LT(test::relative_error(path_interval(BallCutter{5}, 1 / rho, 0.01).chord,
                                       expected),
                  1e-13);
        EXPECT_GT(test::relative_error(printed_interval(5, rho, 0.01), expected), 1e-3);
    }
    EXPECT_LT(test::relative_error(printed_interval(5, 100, 1), 5.82572309614670), 1e-9)
        << "the printed form is right where it does not cancel";
}

TEST(PathInterval, GrowsWithTheScallopAndWithTheConcavity)
{
    const BallCutter ball{5};
    for (const double k : {-0.15, -0.05, 0.0, 0.1, 1.0}) {
        double last = 0;
        for (double h = 1e-4; h < 4; h *= 1.2) {
            const double chord = path_interval(ball, k, h).chord;
            EXPECT_GE(chord, last);
            last = chord;
        }
        EXPECT_GT(path_interval(ball, k - 0.01, 0.01).chord,
                  path_interval(ball, k, 0.01).chord);
    }
}

TEST(PathInterval, ScalesExactlyWithPowersOfTwo)
{
    const PathInterval interval = path_interval(BallCutter{7.5}, -0.03, 0.2);
    const PathInterval scaled =
        path_interval(BallCutter{7.5 * 0x1p11}, -0.03 * 0x1p-11, 0.2 * 0x1p11);
    EXPECT_EQ(scaled.chord, 0x1p11 * interval.chord);
    EXPECT_EQ(scaled.projected, 0x1p11 * interval.projected);
    EXPECT_EQ(scaled.half_angle.radians(), interval.half_angle.radians());
}

TEST(HighestScallop, IsWhereTheBallsTouchSideBySide)
{
    // There the centres lie 2R apart on the circle of radius rho + R, and the peak is the
    // middle between them: (rho + h)^2 = (rho + R)^2 - R^2.
    for (const double rho : {1.0, 10.0, 1e4, -10.5, -30.0, -1e4}) {
        const double h = highest_scallop(BallCutter{5}, 1 / rho);
        EXPECT_LT(test::relative_error((rho + h) * (rho + h), (rho + 5) * (rho + 5) - 25),
                  1e-12)
            << rho;
        EXPECT_GT(h, 0);
    }
    EXPECT_EQ(highest_scallop(BallCutter{5}, 0), 5);
    EXPECT_EQ(highest_scallop(BallCutter{5}, -0.1), 10);
    EXPECT_EQ(highest_scallop(BallCutter{5}, -0.11), infinity);
}

struct ScallopVector {
    double k;
    double h;
};

// Vectors computed with 50 digits: R = 7.5, interval 5.
TEST(ScallopHeight, IsTheTabulatedOne)
{
    for (const auto& [k, h] : {ScallopVector{0, 0.428932188134525},
                               {0.02, 0.501004520636059},
                               {-0.02, 0.360497054285969}})
        EXPECT_LT(test::relative_error(scallop_height(BallCutter{7.5}, k, 5), h), 1e-14);
}

TEST(ScallopHeight, GivesBackTheScallopOfAnInterval)
{
    test::Random random{3};
    for (int n = 0; n < 5000; ++n) {
        const BallCutter ball{random.log_uniform(0.1, 100)};
        const double R = ball.radius();
        const double k = random.uniform(-0.95, 3) / R;
        const double highest = std::min(highest_scallop(ball, k), 2 * R);
        const double share = random.log_uniform(1e-6, 0.99);
        const PathInterval interval = path_interval(ball, k, share * highest);
        if (interval.status == LengthStatus::Ok) {
            EXPECT_LT(test::relative_error(scallop_height(ball, k, interval.chord),
                                           share * highest),
                      1e-12)
                << k * R << ' ' << share;
        }
    }
}

TEST(ScallopHeight, NearItsHighestStillGivesBackNineDigits)
{
    for (const double k : {-0.09, -0.02, 0.0, 0.1, 1.0})
        for (const double share : {0.995, 0.999, 0.9999}) {
            const double h = share * highest_scallop(BallCutter{5}, k);
            const PathInterval interval = path_interval(BallCutter{5}, k, h);
            if (interval.status == LengthStatus::Ok) {
                EXPECT_LT(test::relative_error(
                              scallop_height(BallCutter{5}, k, interval.chord), h),
                          1e-9);
            }
        }
}

TEST(ScallopHeight, RefusesIntervalsThatNoTwoBallsLeave)
{
    const BallCutter ball{5};
    EXPECT_THROW(scallop_height(ball, -0.2, 1), GeometryError) << "the ball does not fit";
    EXPECT_THROW(scallop_height(ball, 0, 10.001), GeometryError)
        << "the balls do not meet";
    EXPECT_THROW(scallop_height(ball, -0.15, 13.4), GeometryError)
        << "longer than the circle";
    EXPECT_EQ(scallop_height(ball, 0, 10), 5);
    for (const double l : {0.0, -1.0, infinity, nan})
        EXPECT_THROW(scallop_height(ball, 0, l), DomainError) << l;
    for (const double k : {infinity, nan})
        EXPECT_THROW(scallop_height(ball, k, 1), DomainError) << k;
}

// Two corner circles whose centres lie l - 2f apart meet at half that distance from each,
// found here without the square root of the formula: the peak is on both circles.
TEST(LevelPathInterval, PutsThePeakOnBothCornerCircles)
{
    for (const Cutter& cutter : {Cutter::ball(5), Cutter{5, 2}, Cutter{8, 0.5}})
        for (const double share : {1e-4, 0.01, 0.3, 0.9}) {
            const double r = cutter.corner_radius();
            const double h = share * r;
            const double l = level_path_interval(cutter, h);
            const double half_gap = l / 2 - cutter.flat_radius();
            EXPECT_NEAR(std::hypot(half_gap, r - h), r, 1e-13 * r);
            EXPECT_LT(test::relative_error(level_scallop_height(cutter, l).value(), h),
                      1e-11);
        }
}

TEST(LevelPathInterval, IsThatOfABallOnAPlaneForABall)
{
    EXPECT_EQ(level_path_interval(Cutter::ball(3), 0.1),
              path_interval(BallCutter{3}, 0, 0.1).chord);
}

TEST(LevelPathInterval, RefusesAScallopThatNoCornerLeaves)
{
    EXPECT_THROW(level_path_interval(Cutter::flat(5), 0.1), DomainError);
    for (const double h : {0.0, -1.0, 4.0, 5.0, infinity, nan})
        EXPECT_THROW(level_path_interval(Cutter{5, 2}, h), DomainError) << h;
}

TEST(LevelScallopHeight, IsZeroUnderTheFlatBottomAndMissingBeyondTheCorners)
{
    const Cutter bull{5, 2};  // flat up to 3 mm from the axis
    EXPECT_EQ(level_scallop_height(bull, 5), 0);
    EXPECT_EQ(level_scallop_height(bull, 6), 0);
    EXPECT_GT(level_scallop_height(bull, 6.001).value(), 0);
    EXPECT_NEAR(level_scallop_height(bull, 9.999999).value(), 2, 1e-2);
    EXPECT_FALSE(level_scallop_height(bull, 10));
    EXPECT_EQ(level_scallop_height(Cutter::flat(5), 10), 0);
    EXPECT_FALSE(level_scallop_height(Cutter::flat(5), 10.1));
    for (const double interval : {infinity, nan})
        EXPECT_THROW(level_scallop_height(bull, interval), DomainError);
}

}  // namespace
}  // namespace endmill
