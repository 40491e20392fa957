// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/composite_curve.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

// The parabola z = x^2 / 100 over 0 to 90 in `pieces` pieces: each parameter is 90 / pieces
// of x.
CompositeCurve parabola(int pieces)
{
    const double width = 90.0 / pieces;
    std::vector<Vec3> points{{0, 0, 0}};
    for (int i = 0; i < pieces; ++i) {
        const double low = width * i;
        const double high = low + width;
        for (const double share : {1 / 3.0, 2 / 3.0, 1.0}) {
            const double x = low + share * width;
            // The blossom of x^2 at (low, high) and the nearer end.
            const double square = share < 0.5   ? low * (low + 2 * high) / 3
                                  : share < 0.9 ? high * (2 * low + high) / 3
                                                : high * high;
            points.emplace_back(x, 0, square / 100);
        }
    }
    return CompositeCurve{points};
}

TEST(CompositeCurve, HasThePointsAndDerivativesOfItsPolynomial)
{
    const CompositeCurve curve = parabola(3);
    for (const double t : {-0.5, 0.0, 0.3, 1.0, 2.5, 3.0, 3.5}) {
        const double x = 30 * t;
        const CurveJet jet = curve.jet(t);
        EXPECT_NEAR((jet.point - Vec3(x, 0, x * x / 100)).norm(), 0, 1e-12);
        EXPECT_NEAR((jet.first - Vec3(30, 0, 30 * x / 50)).norm(), 0, 1e-12);
        EXPECT_NEAR((jet.second - Vec3(0, 0, 18)).norm(), 0, 1e-11);
        EXPECT_NEAR((curve.point(t) - jet.point).norm(), 0, 1e-12);
    }
}

TEST(CompositeCurve, ReachesADistanceAlongItsChord)
{
    const CompositeCurve curve = parabola(3);
    const auto reached = curve.first_reach(0.5, Vec3::UnitX(), 50);
    ASSERT_TRUE(reached.has_value());
    EXPECT_NEAR(*reached, 0.5 + 50 / 30.0, 1e-12);
    EXPECT_FALSE(curve.first_reach(0.5, Vec3::UnitX(), 76).has_value());
    // Downhill the parabola turns away after its vertex.
    EXPECT_FALSE(curve.first_reach(0, -Vec3::UnitZ(), 1).has_value());
}

TEST(CompositeCurve, ReversedRunsBackwards)
{
    const CompositeCurve curve = parabola(2);
    const CompositeCurve back = reversed(curve);
    for (const double t : {0.0, 0.4, 1.0, 1.7})
        EXPECT_NEAR((back.point(2 - t) - curve.point(t)).norm(), 0, 1e-12);
}

TEST(CompositeCurve, RefusesWrongControlPoints)
{
    EXPECT_THROW(CompositeCurve{std::vector<Vec3>(3)}, DomainError);
    EXPECT_THROW(CompositeCurve{std::vector<Vec3>(6)}, DomainError);
    std::vector<Vec3> points(4, Vec3::Zero());
    points[2].x() = std::numeric_limits<double>::infinity();
    EXPECT_THROW(CompositeCurve{points}, DomainError);
}

}  // namespace
}  // namespace endmill
