// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/curve_target.h"

#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/planning/detail/economy_tables.h"

namespace endmill {
namespace {

// Quarter turns of a circle as cubic pieces; a cubic represents one to 3e-4 of the radius.
CompositeCurve circle(double radius, int quarters)
{
    const double handle = 4.0 / 3 * std::tan(std::acos(-1.0) / 8);
    const auto turned = [&](double x, double z, int quarter) {
        for (int i = 0; i < quarter; ++i) {
            const double before = x;
            x = -z;
            z = before;
        }
        return Vec3{radius * x, 0, radius * z};
    };
    std::vector<Vec3> points{{radius, 0, 0}};
    for (int i = 0; i < quarters; ++i)
        for (const auto& [x, z] :
             {std::pair{1.0, handle}, std::pair{handle, 1.0}, std::pair{0.0, 1.0}})
            points.push_back(turned(x, z, i));
    return CompositeCurve{points};
}

TEST(CurveTarget, IntegralsOfACircle)
{
    const double pi = std::acos(-1.0);
    const CurveIntegrals integrals = curve_integrals(circle(50, 2));
    EXPECT_NEAR(integrals.arc_mm, 50 * pi, 50 * pi * 1e-3);
    EXPECT_NEAR(integrals.turning, pi, pi * 1e-3);
    EXPECT_NEAR(integrals.root_curvature, std::sqrt(50) * pi, 50 * 1e-2);
}

// On a circle every step has the chord 2 sqrt(2 r delta - delta^2) and the angle
// 2 acos(1 - delta / r).
TEST(CurveTarget, CountsPointsAndChordsOfACircle)
{
    const double radius = 50;
    const auto march = march_both_ways(circle(radius, 2));
    ASSERT_TRUE(march.has_value());
    for (int i = 0; i < 3; ++i) {
        const double delta = table_tolerances_mm[i];
        const double angle = 2 * std::acos(1 - delta / radius);
        const double steps = std::acos(-1.0) / angle;
        const int points = static_cast<int>(std::floor(steps)) + 2;
        EXPECT_EQ((*march)[i].points_forward, points);
        EXPECT_EQ((*march)[i].points_backward, points);
        const double last = steps - std::floor(steps);
        const double length =
            2 * radius *
            (std::floor(steps) * std::sin(angle / 2) + std::sin(last * angle / 2));
        EXPECT_NEAR((*march)[i].forward_mm, length, 0.05);
        EXPECT_NEAR((*march)[i].backward_mm, length, 0.05);
    }
}

TEST(CurveTarget, PassesOfACircleAreRegularAndThoseThatSkipABendAreNot)
{
    EXPECT_TRUE(has_regular_passes(march_both_ways(circle(50, 2)).value()));
    // A step from a straight start is not limited by curvature: the forward pass goes from end to end.
    std::vector<Vec3> points{{50, 0, -90}, {50, 0, -60}, {50, 0, -30}};
    const CompositeCurve arc = circle(50, 2);
    points.insert(points.end(), arc.points().begin(), arc.points().end());
    const auto skipping = march_both_ways(CompositeCurve{points}).value();
    ASSERT_EQ(skipping[0].points_forward, 2);
    EXPECT_FALSE(has_regular_passes(skipping));
}

TEST(CurveTarget, LossVanishesOnTheNumbersOfTheCurveItself)
{
    const auto march = march_both_ways(circle(60, 2));
    ASSERT_TRUE(march.has_value());
    CurveTarget target{};
    for (int i = 0; i < 3; ++i)
        target[i] = {(*march)[i].points_forward + (*march)[i].points_backward,
                     (*march)[i].points_forward,
                     ((*march)[i].forward_mm + (*march)[i].backward_mm) / 2, 0.01};
    EXPECT_EQ(curve_loss(*march, target), 0);
    EXPECT_EQ(curve_matches(*march, target), 9);
    // Without f, the sum counts twice.
    target[1].points_forward.reset();
    EXPECT_EQ(curve_loss(*march, target), 0);
    EXPECT_EQ(curve_matches(*march, target), 9);

    target[2].chord_mm += 1.01;
    EXPECT_NEAR(curve_loss(*march, target), 1, 1e-9);
    EXPECT_EQ(curve_loss(circle(60, 2), target, 100), curve_loss(*march, target));
    EXPECT_EQ(curve_matches(*march, target), 8);
    target[2].chord_mm -= 1.01;
    target[0].points_a_pair += 1;
    *target[0].points_forward += 1;
    EXPECT_GT(curve_loss(*march, target), 0);
    EXPECT_EQ(curve_matches(*march, target), 8);
}

}  // namespace
}  // namespace endmill
