// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/section_order.h"

#include <gtest/gtest.h>

#include "endmill/trimming/detail/plane_points.h"
#include "random.h"
#include "trimmed_curves.h"

namespace endmill {
namespace {

int sign(double value)
{
    return (value > 0) - (value < 0);
}

// Segments 0, 2, 4, 6 of points on a grid with many coincidences; with `off`, one
// rounding error away.
SectionCurve random_points(test::Random& random, double off)
{
    SectionCurve curve;
    const auto coordinate = [&](double low) {
        return std::floor(random.uniform(low, low + 4)) +
               off * std::floor(random.uniform(-1, 2));
    };
    for (int k = 0; k < 4; ++k) {
        curve.points.emplace_back(coordinate(0), coordinate(0));
        curve.points.emplace_back(coordinate(5), coordinate(0));
    }
    return curve;
}

// Compares the filtered comparisons with integer arithmetic.
void expect_exact(const SectionCurve& curve)
{
    const PlanePoints plane{{&curve, 1}};
    const SectionOrder order{plane.section()};
    const SectionLine a = order.line(0);
    const SectionLine b = order.line(2);
    const SectionLine c = order.line(4);
    for (std::int32_t vertex = 4; vertex < 8; ++vertex) {
        const double s = order.s(vertex);
        EXPECT_EQ(order.height_order(0, 2, s), exact_height_order(a, b, s));
    }
    if (exact_height_order(a, b, 4) * exact_height_order(a, b, 5) >= 0)
        return;
    const EnvelopeCrossing x = order.crossing(0, 2);
    const SectionPoint true_x = exact_crossing(a, b);
    EXPECT_LE(std::abs(x.s - true_x[0]), x.error + 0x1p-50);
    EXPECT_LE(std::abs(x.z - true_x[1]), x.error + 0x1p-50);
    EXPECT_LT(x.error, 1e-12);
    EXPECT_EQ(order.side(4, x), exact_side(c, a, b));
    for (const double s : {true_x[0], 4.5, 5.0})
        EXPECT_EQ(order.order(x, s), exact_order(a, b, s));
    if (exact_height_order(a, c, 4) * exact_height_order(a, c, 5) < 0) {
        const EnvelopeCrossing y = order.crossing(0, 4);
        EXPECT_EQ(order.order(x, y), exact_order(a, b, a, c));
    }
}

TEST(SectionOrder, AgreesWithIntegerArithmetic)
{
    test::Random random{9};
    for (const double off : {0.0, 0x1p-50, 0.1})
        for (int k = 0; k < 3000; ++k)
            expect_exact(random_points(random, off));
}

TEST(SectionOrder, GivesTheSideForBothDirectionsOfASegment)
{
    const SectionCurve curve =
        test::open_curve({{0, 0}, {2, 2}, {0, 0}, {1, 1}, {1, 2}, {1, 0}});
    const PlanePoints plane{{&curve, 1}};
    const SectionOrder order{plane.section()};
    for (const std::int32_t segment : {0, 1}) {
        EXPECT_EQ(order.side(segment, 3), 0);
        EXPECT_EQ(order.side(segment, 4), 1);
        EXPECT_EQ(order.side(segment, 5), -1);
    }
    EXPECT_EQ(sign(order.s(1)), 1);
}

}  // namespace
}  // namespace endmill
