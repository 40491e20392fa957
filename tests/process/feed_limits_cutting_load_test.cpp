// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/feed_limits.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "milling_examples.h"
#include "random.h"

namespace endmill {
namespace {

using test::relative_error;
using test::steel;

constexpr double newton_per_kgf = 9.80665;

// All teeth of a slot one radius deep: I5 = 1/pi, I6 = 1/2, I7 = 1/4, I8 = pi/8.
EdgeSums slot(double factor)
{
    return scaled({1 / std::numbers::pi, 0.5, 0.25, std::numbers::pi / 8}, factor);
}

EdgeSums random_sums(test::Random& random)
{
    return {random.log_uniform(0.01, 3), random.log_uniform(0.01, 3),
            random.log_uniform(0.01, 3), random.log_uniform(0.01, 3)};
}

CuttingMaterial random_material(test::Random& random)
{
    CuttingMaterial material = steel();
    material.specific_resistance_n_per_mm2 = random.log_uniform(200, 4000);
    material.edge_thickness_mm = random.log_uniform(1e-3, 0.05);
    material.r1 = random.uniform(0, 1.5);
    material.r2 = random.uniform(0, 1.5);
    material.r3 = random.uniform(0.05, 1.5);
    material.r4 = random.uniform(0, 1.5);
    return material;
}

TEST(CuttingLoad, OfASlotIsTheRequestedForce)
{
    CuttingMaterial material = steel();
    material.specific_resistance_n_per_mm2 = 2000;
    const LoadModel model{material, 5, LimitForm::Paper};
    const auto bounds = feed_bounds(model, slot(2 * 1.8), {.cutting_force_n = 1200});
    ASSERT_TRUE(bounds.cutting_force);
    EXPECT_FALSE(bounds.thrust || bounds.torque);
    EXPECT_LT(relative_error(*bounds.cutting_force, 0.072097110475), 1e-9);
    // The same by the paper's equation (15), written out.
    const double by_hand =
        std::numbers::pi * (1200 / (std::sqrt(1.16) * 1.8 * 2 * 5 * 2000) - 0.016 / 2);
    EXPECT_LT(relative_error(*bounds.cutting_force, by_hand), 1e-14);
}

TEST(CuttingLoad, AtABoundIsTheLimit)
{
    test::Random random{11};
    int bound = 0;
    for (int i = 0; i < 2000; ++i) {
        const LimitForm form = i % 2 == 0 ? LimitForm::Paper : LimitForm::Exact;
        const LoadModel model{random_material(random), random.uniform(1, 20), form};
        const EdgeSums sums = random_sums(random);
        const LoadLimits limits{random.log_uniform(10, 1e4), random.log_uniform(10, 1e4),
                                random.log_uniform(0.1, 100)};
        const FeedBounds bounds = feed_bounds(model, sums, limits);
        const CuttingLoads edge = cutting_loads(model, sums, 0);
        const auto check = [&](double feed, double limit, double CuttingLoads::*load) {
            if (feed == 0) {
                EXPECT_GE(edge.*load, limit * (1 - 1e-15));
            } else {
                EXPECT_LT(relative_error(cutting_loads(model, sums, feed).*load, limit),
                          1e-12);
                ++bound;
            }
        };
        check(bounds.cutting_force.value(), *limits.cutting_force_n,
              &CuttingLoads::cutting_force_n);
        check(bounds.thrust.value(), *limits.thrust_n, &CuttingLoads::thrust_n);
        check(bounds.torque.value(), *limits.torque_n_m, &CuttingLoads::torque_n_m);
    }
    EXPECT_GT(bound, 2000);
}

// The factor sqrt(1 + r1^2) of the paper is exact only for r2 = r1.
TEST(CuttingLoad, FormsAgreeWhereR2IsR1)
{
    test::Random random{5};
    for (int i = 0; i < 200; ++i) {
        CuttingMaterial material = random_material(random);
        const EdgeSums sums = random_sums(random);
        const double feed = random.uniform(0, 0.3);
        const double other =
            cutting_loads({material, 5, LimitForm::Exact}, sums, feed).cutting_force_n;
        EXPECT_GT(
            relative_error(cutting_loads({material, 5, LimitForm::Paper}, sums, feed)
                               .cutting_force_n,
                           other),
            0);
        material.r2 = material.r1;
        EXPECT_LT(
            relative_error(cutting_loads({material, 5, LimitForm::Paper}, sums, feed)
                               .cutting_force_n,
                           cutting_loads({material, 5, LimitForm::Exact}, sums, feed)
                               .cutting_force_n),
            1e-15);
    }
}

// docs/methods/ball-end-milling.md, section 8: where the force limit binds,
// F_z = r3 F/S + (r4 - r3) R_m m r0 K h* I6.
TEST(CuttingLoad, ThrustAtTheForceLimitFollowsFromTheEdgeAlone)
{
    test::Random random{8};
    for (int i = 0; i < 300; ++i) {
        const LoadModel model{random_material(random), random.uniform(1, 20),
                              LimitForm::Paper};
        const EdgeSums sums = random_sums(random);
        const double limit = 2 * cutting_loads(model, sums, 0.01).cutting_force_n;
        const double feed =
            feed_bounds(model, sums, {.cutting_force_n = limit}).cutting_force.value();
        const CuttingMaterial& material = model.material;
        const double expected =
            material.r3 * limit / std::sqrt(1 + material.r1 * material.r1) +
            (material.r4 - material.r3) * model.radius *
                material.specific_resistance_n_per_mm2 * material.edge_thickness_mm *
                sums.edge;
        EXPECT_LT(relative_error(cutting_loads(model, sums, feed).thrust_n, expected),
                  1e-12);
    }
}

// With r1 = r2 and r3 = r4 both limits are proportional, so one of them never binds.
TEST(CuttingLoad, ForceAndThrustAreProportionalIfR1IsR2AndR3IsR4)
{
    CuttingMaterial material = steel();
    material.r2 = material.r1;
    material.r4 = material.r3;
    test::Random random{2};
    for (int i = 0; i < 100; ++i) {
        const CuttingLoads loads = cutting_loads(
            {material, 5, LimitForm::Exact}, random_sums(random), random.uniform(0, 0.2));
        EXPECT_NEAR(loads.thrust_n / loads.cutting_force_n,
                    material.r3 / std::hypot(1, material.r1), 1e-14);
    }
}

TEST(CuttingLoad, BoundsNothingInAir)
{
    const FeedBounds bounds =
        feed_bounds({steel(), 5, LimitForm::Exact}, {},
                    {.cutting_force_n = 1, .thrust_n = 1, .torque_n_m = 1});
    EXPECT_FALSE(bounds.cutting_force || bounds.thrust || bounds.torque);
    EXPECT_FALSE(feed_bounds({steel(), 5, LimitForm::Paper}, {}, {.cutting_force_n = 1})
                     .cutting_force);
    EXPECT_FALSE(equivalent_radius({steel(), 5}, {}, 0.1));
}

TEST(CuttingLoad, OfTheEdgeAloneMayExceedALimit)
{
    for (const LimitForm form : {LimitForm::Paper, LimitForm::Exact}) {
        const LoadModel model{steel(), 5, form};
        const CuttingLoads edge = cutting_loads(model, slot(2), 0);
        const FeedBounds bounds = feed_bounds(
            model, slot(2),
            {edge.cutting_force_n / 2, edge.thrust_n / 2, edge.torque_n_m / 2});
        EXPECT_EQ(bounds.cutting_force, 0);
        EXPECT_EQ(bounds.thrust, 0);
        EXPECT_EQ(bounds.torque, 0);
    }
}

TEST(CuttingLoad, WithoutAForceOfItsKindBoundsNothing)
{
    CuttingMaterial material = steel();
    material.r3 = 0;
    const LoadModel model{material, 5, LimitForm::Exact};
    const double edge = cutting_loads(model, slot(2), 0).thrust_n;
    EXPECT_FALSE(feed_bounds(model, slot(2), {.thrust_n = edge}).thrust);
    EXPECT_FALSE(feed_bounds(model, slot(2), {.thrust_n = 2 * edge}).thrust);
    EXPECT_EQ(feed_bounds(model, slot(2), {.thrust_n = edge / 2}).thrust, 0);
}

TEST(CuttingLoad, PowerIsTorqueTimesAngularSpeed)
{
    EXPECT_NEAR(cutting_power_w(LimitForm::Exact, 10, 60), 20 * std::numbers::pi, 1e-13);
    // By the paper 974000 kgf mm at 1 rpm are 1 kW; the exact value is 973757.2551.
    const double paper_torque_n_m = 974000 * newton_per_kgf / 1000;
    EXPECT_NEAR(cutting_power_w(LimitForm::Paper, paper_torque_n_m, 1), 1000, 1e-9);
    const double exact_torque_n_m = 973757.2551 * newton_per_kgf / 1000;
    EXPECT_NEAR(cutting_power_w(LimitForm::Exact, exact_torque_n_m, 1), 1000, 1e-6);
}

TEST(CuttingLoad, EquivalentRadiusHasTheTorqueOfTheTangentialForce)
{
    test::Random random{4};
    for (int i = 0; i < 50; ++i) {
        CuttingMaterial material = random_material(random);
        material.r1 = material.r2 = 0;  // the cutting force equals the tangential force
        const LoadModel model{material, 6, LimitForm::Exact};
        const EdgeSums sums = random_sums(random);
        const CuttingLoads loads = cutting_loads(model, sums, 0.07);
        EXPECT_LT(relative_error(equivalent_radius(model, sums, 0.07).value(),
                                 1000 * loads.torque_n_m / loads.cutting_force_n),
                  1e-14);
    }
}

}  // namespace
}  // namespace endmill
