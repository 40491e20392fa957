// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/cutting_force.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/process/detail/force_pattern.h"
#include "endmill/process/detail/helical_edge.h"
#include "random.h"

namespace endmill {
namespace {

using std::numbers::pi;

const CuttingMaterial material{2000, 0.016, 0.4, 0.5, 0.2, 0.6, 0.37, 28};

MillingCut cut(const BallEngagement& engagement, ChipModel chip, int flutes, double helix)
{
    return {engagement, chip, material, {5, flutes, helix}, 0.1, Milling::Down, {}};
}

CuttingForce force_at(const MillingCut& cut, double turn)
{
    return force_profile(cut, std::array{turn}).front();
}

// Mean over a turn, integrated between the events of all flutes. The nodes are dense near
// the events, where the force behaves like a square root.
CuttingForce mean_over_turn(const MillingCut& cut)
{
    constexpr int samples = 100;
    const int flutes = cut.tool.flutes;
    const HelicalEdge edge{cut.engagement, cut.tool.helix};
    std::vector<double> ends{0, 2 * pi};
    for (const double event : edge.events())
        for (int flute = 0; flute < flutes; ++flute) {
            const double turn = event + 2 * pi * flute / flutes;
            ends.push_back(turn < 2 * pi ? turn : turn - 2 * pi);
        }
    std::sort(ends.begin(), ends.end());
    std::vector<double> turns;
    std::vector<double> weights;
    for (std::size_t k = 1; k < ends.size(); ++k) {
        const double length = ends[k] - ends[k - 1];
        if (length < 1e-12)
            continue;
        for (int j = 0; j < samples; ++j) {
            const double angle = pi * (j + 0.5) / samples;
            turns.push_back(ends[k - 1] + length * (1 - std::cos(angle)) / 2);
            weights.push_back(length / 2 * std::sin(angle) * pi / samples / (2 * pi));
        }
    }
    const std::vector<CuttingForce> forces = force_profile(cut, turns);
    CuttingForce mean{0, 0, 0, 0};
    for (std::size_t k = 0; k < forces.size(); ++k) {
        mean.x_n += weights[k] * forces[k].x_n;
        mean.y_n += weights[k] * forces[k].y_n;
        mean.z_n += weights[k] * forces[k].z_n;
        mean.torque_n_m += weights[k] * forces[k].torque_n_m;
    }
    return mean;
}

void expect_near(const CuttingForce& found, const CuttingForce& expected, double relative)
{
    const double size = std::hypot(expected.x_n, expected.y_n, expected.z_n);
    EXPECT_NEAR(found.x_n, expected.x_n, relative * size);
    EXPECT_NEAR(found.y_n, expected.y_n, relative * size);
    EXPECT_NEAR(found.z_n, expected.z_n, relative * size);
    EXPECT_NEAR(found.torque_n_m, expected.torque_n_m,
                relative * std::abs(expected.torque_n_m));
}

CuttingForce mean_of_model(const MillingCut& cut)
{
    return mean_force(cutting_coefficients(cut.engagement, cut.chip), cut.material,
                      cut.tool, cut.feed_per_tooth_mm, cut.milling);
}

TEST(ForceProfile, HasTheMeanOfTheMeanModelForAnyHelix)
{
    test::Random random{51};
    for (int n = 0; n < 8; ++n) {
        const BallEngagement engagement{random.uniform(-1, 1), random.uniform(-0.9, 0.9),
                                        random.uniform(0.1, 1), random.uniform(0.2, 1.8)};
        MillingCut one = cut(engagement, n % 2 == 0 ? ChipModel::Paper : ChipModel::Exact,
                             1 + n % 3, n == 5 ? 0 : random.uniform(0, 1));
        one.milling = n % 4 < 2 ? Milling::Up : Milling::Down;
        expect_near(mean_over_turn(one), mean_of_model(one), 2e-4);
    }
}

// The sums of a force pattern are closed. Without runout they determine torque and
// thrust.
TEST(ForceProfile, HasTheTorqueAndThrustOfTheForcePattern)
{
    test::Random random{52};
    for (int n = 0; n < 40; ++n) {
        const BallEngagement engagement{random.uniform(-1, 1), random.uniform(-0.9, 0.9),
                                        random.uniform(0.1, 1), random.uniform(0.2, 1.8)};
        const MillingCut one =
            cut(engagement, n % 2 == 0 ? ChipModel::Paper : ChipModel::Exact, 3, 0.6);
        const ForcePattern pattern{engagement, one.chip, one.tool};
        const double turn = random.uniform(0, 2 * pi);
        const CuttingForce force = force_at(one, turn);
        const EdgeSums sums = pattern.at(turn);
        const double scale = 2000 * 5;
        EXPECT_NEAR(force.z_n, scale * (0.2 * 0.1 * sums.chip + 0.6 * 0.016 * sums.edge),
                    1e-6);
        EXPECT_NEAR(
            force.torque_n_m,
            -scale * 5 / 1000 * (0.1 * sums.chip_torque + 0.016 * sums.edge_torque),
            1e-8);
    }
}

// Uphill nothing is cut near azimuth 0, so no chip is clipped. The runout terms of the
// flutes cancel in the mean.
TEST(ForceProfile, HasTheSameMeanWithRunoutWhileNoChipIsClipped)
{
    for (const ChipModel chip : {ChipModel::Paper, ChipModel::Exact}) {
        MillingCut one = cut({0.1, 0.6, 0.6, 0.4}, chip, 3, 0.5);
        one.feed_per_tooth_mm = chip == ChipModel::Paper ? 0.1 : 100;
        one.runout = {1e-3, 0.7};
        const double accuracy = chip == ChipModel::Paper ? 2e-4 : 1e-3;
        expect_near(mean_over_turn(one), mean_of_model(one), accuracy);
    }
}

// Runout makes the chip of one flute thicker and that of the next thinner.
TEST(ForceProfile, OfTwoFlutesWithRunoutDiffersFromFluteToFlute)
{
    MillingCut one = cut({0, 0, 0, 1, PreviousPass::None}, ChipModel::Paper, 2, 0);
    const double offset = 0.02;
    one.runout = {offset, 0};
    // Flute 0 stands at 90 degrees with flute 1 out of the cut, then the other way round.
    // The torque is K r0^2 (t + h) pi/4 with t = f + 2 e and f - 2 e.
    const double scale = 2000 * 25 * pi / 4 / 1000;
    EXPECT_NEAR(-force_at(one, pi / 2).torque_n_m, scale * (0.1 + 2 * offset + 0.016),
                1e-9);
    EXPECT_NEAR(-force_at(one, -pi / 2).torque_n_m, scale * (0.1 - 2 * offset + 0.016),
                1e-9);
}

TEST(ForceProfile, WithMoreRunoutThanFeedLeavesAFluteIdle)
{
    MillingCut one = cut({0, 0, 0, 1, PreviousPass::None}, ChipModel::Paper, 2, 0.4);
    one.runout = {0.2, 0};
    EXPECT_EQ(force_at(one, -pi / 2).torque_n_m, 0);
    EXPECT_LT(force_at(one, pi / 2).torque_n_m, 0);
}

// A slot without helix at 90 degrees, milling up: the tangential force acts along -y, the
// radial force along x.
TEST(ForceProfile, OfAStraightFluteIsClosed)
{
    MillingCut one = cut({0, 0, 0, 1, PreviousPass::None}, ChipModel::Paper, 1, 0);
    one.milling = Milling::Up;
    const CuttingForce force = force_at(one, pi / 2);
    EXPECT_NEAR(force.y_n, -2000 * 5 * (0.1 + 0.016), 1e-9);
    EXPECT_NEAR(force.x_n, 2000 * 5 * (0.4 * 0.1 + 0.5 * 0.016), 1e-9);
    EXPECT_NEAR(force.z_n, 2000 * 5 * (0.2 * 0.1 + 0.6 * 0.016), 1e-9);
    EXPECT_NEAR(force.torque_n_m, 2000 * 25 * pi / 4 * (0.1 + 0.016) / 1000, 1e-9);
}

TEST(ForceProfile, InAirIsZero)
{
    const CuttingForce force =
        force_at(cut({0, 0, 0.5, -1}, ChipModel::Exact, 2, 0.5), 1);
    EXPECT_EQ(force.x_n, 0);
    EXPECT_EQ(force.torque_n_m, 0);
}

TEST(ForceProfile, RefusesUnsoundCuts)
{
    const MillingCut good = cut({0, 0, 0.5, 1}, ChipModel::Paper, 2, 0.5);
    MillingCut bad = good;
    bad.feed_per_tooth_mm = -0.1;
    EXPECT_THROW(force_at(bad, 0), DomainError);
    bad = good;
    bad.runout.offset_mm = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(force_at(bad, 0), DomainError);
    bad = good;
    bad.tool.flutes = 0;
    EXPECT_THROW(force_at(bad, 0), DomainError);
}

// A right-hand cutter under M03 beside a level groove on its left, integrated in the
// frame of the machine: x along the feed, y to its left. The spindle turns from y towards
// x, and the edges trail as they rise. In the model's mirrored frame the helix is
// negative, and the azimuth is pi minus the machine's.
TEST(ForceProfile, MillingDownWithTheNegativeHelixIsARightHandCutterInTheRoom)
{
    const BallEngagement engagement{0, 0, 0.5, 1};
    const double helix = 0.5;
    const int flutes = 2;
    const MillingCut milled = cut(engagement, ChipModel::Paper, flutes, -helix);
    constexpr int steps = 40000;
    for (const double turn : {0.3, 1.1, 1.9, 2.8}) {
        CuttingForce room{0, 0, 0, 0};
        for (int flute = 0; flute < flutes; ++flute)
            for (int k = 0; k < steps; ++k) {
                const double height = (k + 0.5) / steps;
                const double radius = std::sqrt(height * (2 - height));
                const double at =
                    turn + 2 * pi * flute / flutes - height * std::tan(helix);
                const double x = radius * std::sin(at);
                const double to_groove = radius * std::cos(at) - 0.5;
                const bool is_groove = std::abs(to_groove) < 1 &&
                                       height - 1 > -std::sqrt(1 - to_groove * to_groove);
                if (!(x > 0) || is_groove)
                    continue;
                const double chip = milled.feed_per_tooth_mm * std::sin(at);
                const double edge = material.edge_thickness_mm;
                const double scale =
                    material.specific_resistance_n_per_mm2 * milled.tool.radius / steps;
                const double tangential = scale * (chip + edge);
                const double radial = scale * (material.r1 * chip + material.r2 * edge);
                room.x_n += tangential * std::cos(at) + radial * std::sin(at);
                room.y_n += radial * std::cos(at) - tangential * std::sin(at);
                room.z_n += scale * (material.r3 * chip + material.r4 * edge);
                room.torque_n_m += tangential * radius * milled.tool.radius / 1000;
            }
        const CuttingForce found = force_at(milled, pi - turn);
        // The y component and the sense of the torque are mirrored.
        EXPECT_NEAR(found.x_n, room.x_n, 0.1);
        EXPECT_NEAR(found.y_n, -room.y_n, 0.1);
        EXPECT_NEAR(found.z_n, room.z_n, 0.1);
        EXPECT_NEAR(found.torque_n_m, -room.torque_n_m, 1e-3);
    }
}

}  // namespace
}  // namespace endmill
