// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/profile_families.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "trimmed_curves.h"

namespace endmill {
namespace {

OffsetProfile parabola(double p, double R, double from, double to)
{
    return {"parabola",
            [=](double x) { return x * x / (2 * p); },
            [=](double x) { return x / p; },
            from,
            to,
            R};
}

TEST(OffsetCurve, KeepsItsDistance)
{
    const SectionCurve curve = offset_curve(parabola(6, 10, -15, 16), 63);
    ASSERT_EQ(curve.points.size(), 63U);
    for (int i = 0; i < 63; ++i) {
        const double x = -15 + 31.0 * i / 62;
        const SectionPoint away = curve.points[i] - SectionPoint{x, x * x / 12};
        EXPECT_NEAR(away.norm(), 10, 1e-14);
        EXPECT_NEAR(away.dot(SectionPoint{1, x / 6}), 0, 1e-13);
        EXPECT_GT(away.y(), 0);
    }
}

// The offset of z = x^2 / (2 p) crosses itself in (0, p / 2 + R^2 / (2 p)). The crossing
// of its chords has an error proportional to the square of the step, within the numbers
// of docs/methods/interference.md, section 11.
TEST(OffsetCurve, ConvergesToTheCrossingOfTheParabola)
{
    struct Sampling {
        int points;
        double printed;  // mm, for p = 6, R = 10
    };
    constexpr double z = 6.0 / 2 + 10.0 * 10 / (2 * 6);
    for (const auto& [count, printed] : {Sampling{31, 1.05e-2},
                                         {61, 3.55e-3},
                                         {121, 2.6e-4},
                                         {481, 4.6e-5},
                                         {3841, 8e-7}}) {
        const Trimmed trimmed =
            test::trim("3", offset_curve(parabola(6, 10, -15, 16), count));
        double error = 1;
        for (const TrimmedPoint& point : trimmed.curves.at(0).points) {
            if (point.kind == TrimmedKind::Crossing)
                error = std::abs(point.at.y() - z);
        }
        EXPECT_LE(error, 1.01 * printed);
        EXPECT_LE(error * (count - 1) * (count - 1), 13);
    }
}

// R is the radius of an arc whose offset is a single point; segments of length 0 are left
// out.
TEST(OffsetCurve, MergesEqualPoints)
{
    const OffsetProfile flat_wedge{"point",
                                   [](double) { return 0.0; },
                                   [](double x) { return x < 0.5 ? 0.0 : 1.0; },
                                   0,
                                   1,
                                   1};
    const SectionCurve curve = offset_curve(flat_wedge, 2);
    EXPECT_EQ(curve.points.size(), 2U);
    const OffsetProfile arc{"arc",
                            [](double x) { return 5 - std::sqrt(25 - x * x); },
                            [](double x) { return x / std::sqrt(25 - x * x); },
                            -3,
                            3,
                            5};
    const SectionCurve collapsed = offset_curve(arc, 400);
    for (std::size_t i = 1; i < collapsed.points.size(); ++i)
        EXPECT_NE(collapsed.points[i], collapsed.points[i - 1]);
    for (const SectionPoint& point : collapsed.points)
        EXPECT_NEAR((point - SectionPoint(0, 5)).norm(), 0, 1e-14);
}

TEST(OffsetCurve, RefusesInvalidSamplings)
{
    EXPECT_THROW(offset_curve(parabola(1, 1, 0, 1), 1), DomainError);
    EXPECT_THROW(offset_curve(parabola(1, 1, 1, 1), 5), DomainError);
    EXPECT_THROW(offset_curve(parabola(1, 0, 0, 1), 5), DomainError);
}

}  // namespace
}  // namespace endmill
