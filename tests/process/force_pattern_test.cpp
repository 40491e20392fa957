// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/force_pattern.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "milling_examples.h"
#include "random.h"

namespace endmill {
namespace {

using std::numbers::pi;

constexpr double thirty_degrees = pi / 6;

MillingTool tool(int flutes, double helix = thirty_degrees)
{
    return {5, flutes, helix};
}

const CuttingMaterial material{2000, 0.016, 0.4, 0.4, 0.2, 0.6, 0.37, 28};
const LoadModel model{material, 5};
const LoadLimits limits{1200, 450, 20};

struct Vector {
    BallEngagement engagement;
    double peak_factor;
    FeedBounds constant;
    FeedBounds direct;
};

const std::vector<Vector> vectors{
    {{0, 0, 0.5, 1},
     4.35746842,
     {0.240286173, 0.456965763, 1.380849618},
     {0.10707872, 0.19863225, 0.56459160}},
    {{0, -0.3, 0.5, 1},
     4.25860610,
     {0.252753565, 0.476784843, 1.565850146},
     {0.11622500, 0.21440328, 0.65566818}},
    {{-0.4, -0.5, 0.4, 2},
     2.50892509,
     {0.137159625, 0.241501813, 0.832906618},
     {0.09211527, 0.15327879, 0.58730613}},
};

void expect_near(const FeedBounds& found, const FeedBounds& expected, double relative)
{
    EXPECT_NEAR(*found.cutting_force / *expected.cutting_force, 1, relative);
    EXPECT_NEAR(*found.thrust / *expected.thrust, 1, relative);
    EXPECT_NEAR(*found.torque / *expected.torque, 1, relative);
}

// Values of docs/methods/ball-end-milling.md, section 4, sampled with refinement to
// 1e-5.
TEST(ForcePattern, HasThePeaksOfTheVectors)
{
    for (const Vector& v : vectors) {
        const ForcePattern pattern{v.engagement, ChipModel::Paper, tool(2)};
        EXPECT_NEAR(pattern.peak_factor() / v.peak_factor, 1, 1e-6);
        expect_near(pattern.direct_bounds(model, limits), v.direct, 2e-5);
        expect_near(feed_bounds(model, scaled(pattern.mean(), 1.8), limits), v.constant,
                    5e-9);
    }
}

TEST(ForcePattern, OfTorqueBoundsTheFirstVector)
{
    const ForcePattern pattern{vectors[0].engagement, ChipModel::Paper, tool(2)};
    const EdgeSums peak = scaled(pattern.mean(), pattern.peak_factor());
    expect_near(feed_bounds(model, peak, limits), {0.08233316, 0.13798964, 0.55265032},
                2e-5);
}

// The share of the shank is the difference between a deep cut and one of the depth of the
// ball.
TEST(ForcePattern, OfTheShankHasAClosedPeak)
{
    struct Shank {
        double ratio;
        double length;
        int flutes;
        double peak_factor;
    };
    for (const Shank& shank : {Shank{0.5, 2, 2, 2.72069904635},
                               {0.3, 1.5, 3, 2.41839915231},
                               {0.8, 0.7, 4, 1.79360050253}}) {
        const BallEngagement deep{0, 0, shank.ratio, 1 + shank.length};
        const MillingTool mill = tool(shank.flutes);
        const double tangent = std::tan(thirty_degrees);
        const ForcePattern with{deep, ChipModel::Paper, mill};
        const ForcePattern without{{0, 0, shank.ratio, 1}, ChipModel::Paper, mill};
        double peak = 0;
        double mean = 0;
        constexpr int samples = 20000;
        for (int k = 0; k < samples; ++k) {
            const double turn = 2 * pi * (k + 0.5) / samples;
            const double share = with.at(turn).chip - without.at(turn).chip;
            peak = std::max(peak, share);
            mean += share / samples;
        }
        EXPECT_NEAR(peak / mean, shank.peak_factor, 1e-3);
        const EdgeSums shank_mean = [&] {
            EdgeSums sums = with.mean();
            sums.chip -= without.mean().chip;
            return sums;
        }();
        EXPECT_NEAR(mean, shank_mean.chip, 1e-6);
        if (shank.length * tangent >= shank_angle(deep)) {
            EXPECT_NEAR(peak, shank.ratio / tangent, 1e-6);
        }
    }
}

TEST(ForcePattern, HasTheMeansOfTheCoefficients)
{
    test::Random random{31};
    for (int n = 0; n < 12; ++n) {
        const BallEngagement engagement{random.uniform(-1, 1), random.uniform(-0.9, 0.9),
                                        random.uniform(0.05, 1), random.uniform(0.2, 2)};
        const int flutes = 1 + n % 4;
        const ChipModel chip = n % 2 == 0 ? ChipModel::Paper : ChipModel::Exact;
        const ForcePattern pattern{engagement, chip,
                                   tool(flutes, random.uniform(-0.6, 0.9))};
        EdgeSums mean;
        constexpr int samples = 4000;
        for (int k = 0; k < samples; ++k) {
            const EdgeSums sums = pattern.at(2 * pi / flutes * (k + 0.5) / samples);
            mean.chip += sums.chip / samples;
            mean.edge += sums.edge / samples;
            mean.chip_torque += sums.chip_torque / samples;
            mean.edge_torque += sums.edge_torque / samples;
        }
        const EdgeSums expected = pattern.mean();
        EXPECT_NEAR(mean.chip, expected.chip, 5e-6);
        EXPECT_NEAR(mean.edge, expected.edge, 5e-6);
        EXPECT_NEAR(mean.chip_torque, expected.chip_torque, 5e-6);
        EXPECT_NEAR(mean.edge_torque, expected.edge_torque, 5e-6);
    }
}

// The sums by small steps of height, each tested for engagement.
EdgeSums stepped(const BallEngagement& engagement, ChipModel chip,
                 const MillingTool& mill, double turn)
{
    constexpr int steps = 40000;
    EdgeSums sums;
    for (int flute = 0; flute < mill.flutes; ++flute)
        for (int k = 0; k < steps; ++k) {
            const double latitude = pi / 2 * (k + 0.5) / steps;
            const double azimuth = turn + 2 * pi * flute / mill.flutes -
                                   (1 - std::cos(latitude)) * std::tan(mill.helix);
            if (!is_engaged(engagement, latitude, azimuth))
                continue;
            const double height = std::sin(latitude) * pi / 2 / steps;
            const double thickness =
                chip == ChipModel::Paper
                    ? std::abs(std::sin(azimuth))
                    : std::cos(engagement.lambda) * std::sin(azimuth) -
                          std::sin(engagement.lambda) / std::tan(latitude);
            sums.chip += thickness * height;
            sums.edge += height;
            sums.chip_torque += thickness * height * std::sin(latitude);
            sums.edge_torque += height * std::sin(latitude);
        }
    return sums;
}

TEST(ForcePattern, IsTheSumOverSmallSteps)
{
    for (const BallEngagement& engagement :
         {BallEngagement{-0.4, -0.5, 0.4, 1}, BallEngagement{0.3, 0.2, 0.8, 0.7}})
        for (const ChipModel chip : {ChipModel::Paper, ChipModel::Exact}) {
            const ForcePattern pattern{engagement, chip, tool(2)};
            for (const double turn : {0.1, 0.7, 1.6, 2.9, -8.0}) {
                const EdgeSums expected = stepped(engagement, chip, tool(2), turn);
                const EdgeSums found = pattern.at(turn);
                EXPECT_NEAR(found.chip, expected.chip, 2e-4);
                EXPECT_NEAR(found.edge, expected.edge, 2e-4);
                EXPECT_NEAR(found.chip_torque, expected.chip_torque, 2e-4);
                EXPECT_NEAR(found.edge_torque, expected.edge_torque, 2e-4);
            }
        }
}

TEST(ForcePattern, IsNeverAboveItsPeaks)
{
    test::Random random{32};
    for (int n = 0; n < 25; ++n) {
        const BallEngagement engagement{random.uniform(-1.2, 1.2),
                                        random.uniform(-1.1, 1.1),
                                        random.uniform(0.05, 1), random.uniform(0.2, 2)};
        const ForcePattern pattern{engagement, ChipModel::Paper, tool(2)};
        const double peak = pattern.peak_factor() * pattern.mean().chip_torque;
        const CuttingLoads loads = pattern.largest_loads(model, 0.1);
        double highest = 0;
        for (int k = 0; k < 2000; ++k) {
            const EdgeSums sums = pattern.at(pi * k / 2000);
            highest = std::max(highest, sums.chip_torque);
            const CuttingLoads here = cutting_loads(model, sums, 0.1);
            EXPECT_LE(here.cutting_force_n, loads.cutting_force_n * (1 + 1e-6));
            EXPECT_LE(here.thrust_n, loads.thrust_n * (1 + 1e-6));
            EXPECT_LE(here.torque_n_m, loads.torque_n_m * (1 + 1e-6));
        }
        EXPECT_LE(highest, peak * (1 + 1e-6));
        EXPECT_GE(highest, peak * 0.97);
    }
}

// At the feed that a limit admits, the largest load equals the limit.
TEST(ForcePattern, ReachesEachLimitAtItsBound)
{
    const ForcePattern pattern{{-0.4, -0.5, 0.4, 2}, ChipModel::Exact, tool(3)};
    const FeedBounds bounds = pattern.direct_bounds(model, limits);
    EXPECT_NEAR(pattern.largest_loads(model, *bounds.cutting_force).cutting_force_n, 1200,
                2e-3);
    EXPECT_NEAR(pattern.largest_loads(model, *bounds.thrust).thrust_n, 450, 1e-3);
    EXPECT_NEAR(pattern.largest_loads(model, *bounds.torque).torque_n_m, 20, 5e-5);
}

// Uphill the exact chip is so thin at some turns that its sums are rounding errors of
// either sign. No bound may result from them.
TEST(ForcePattern, OfVanishingChipsKeepsItsBounds)
{
    const LoadModel in_steel{test::steel(), 5};
    const double limit = 1258;
    for (int k = 0; k < 60; ++k) {
        const BallEngagement engagement{-0.15 + 0.013 * k, 0.35 + 0.0107 * k,
                                        0.29 - 0.0013 * k, 1.3 + 0.057 * k};
        const ForcePattern pattern{engagement, ChipModel::Exact, test::ball_10()};
        const FeedBounds bounds = pattern.direct_bounds(in_steel, {limit, {}, {}});
        ASSERT_GT(bounds.cutting_force.value(), 0) << k;
        EXPECT_NEAR(
            pattern.largest_loads(in_steel, bounds.cutting_force.value()).cutting_force_n,
            limit, 1e-4 * limit);
    }
}

TEST(ForcePattern, InAirBoundsNothing)
{
    const ForcePattern pattern{{0, 0, 0.5, -1}, ChipModel::Paper, tool(2)};
    EXPECT_EQ(pattern.peak_factor(), 1);
    EXPECT_EQ(pattern.at(1).edge, 0);
    const FeedBounds bounds = pattern.direct_bounds(model, limits);
    EXPECT_FALSE(bounds.cutting_force || bounds.thrust || bounds.torque);
}

TEST(ForcePattern, HasNoFeedIfTheEdgeForceExceedsTheLimit)
{
    const ForcePattern pattern{{0, 0, 0.5, 1}, ChipModel::Paper, tool(2)};
    EXPECT_EQ(*pattern.direct_bounds(model, {1, {}, {}}).cutting_force, 0);
    EXPECT_FALSE(pattern.direct_bounds(model, {1, {}, {}}).thrust);
}

// Without helix the whole edge cuts at once.
TEST(ForcePattern, WithoutHelixIsThatOfOneAzimuth)
{
    const ForcePattern pattern{
        {0, 0, 0, 1.5, PreviousPass::None}, ChipModel::Paper, tool(1, 0)};
    for (const double turn : {0.4, 1.5, 2.8}) {
        EXPECT_NEAR(pattern.at(turn).chip, 1.5 * std::sin(turn), 1e-12);
        EXPECT_NEAR(pattern.at(turn).edge_torque, 0.5 + pi / 4, 1e-12);
    }
    EXPECT_NEAR(pattern.peak_factor(), pi, 1e-6);
}

// The sums of a right-hand cutter under M03 in the frame of the machine: x along the
// feed, y to its left. The spindle turns clockwise seen from above, from y towards x, and
// a right-hand edge trails as it rises. `side` is 1 with the stock to the left (milling
// up) and -1 to the right (milling down).
EdgeSums in_the_room(const BallEngagement& cut, const MillingTool& mill, double side,
                     double turn)
{
    constexpr int steps = 20000;
    const double top = std::max(1.0, cut.depth_ratio);
    const double a = cut.pick_feed_ratio * std::cos(cut.mu);
    const double b = cut.pick_feed_ratio * std::sin(cut.mu);
    EdgeSums sums;
    for (int flute = 0; flute < mill.flutes; ++flute)
        for (int k = 0; k < steps; ++k) {
            const double height = top * (k + 0.5) / steps;
            if (height > cut.depth_ratio)
                break;
            const double radius = height < 1 ? std::sqrt(height * (2 - height)) : 1;
            const double angle =
                turn + 2 * pi * flute / mill.flutes - height * std::tan(mill.helix);
            const double x = radius * std::sin(angle);
            const double to_stock = side * radius * std::cos(angle);
            const double z = std::min(height, 1.0) - 1;
            const double ahead = x * std::cos(cut.lambda) + z * std::sin(cut.lambda);
            const double rise = z * std::cos(cut.lambda) - x * std::sin(cut.lambda);
            const double from_wall = to_stock + a;
            const bool is_gone = std::abs(from_wall) < 1 &&
                                 rise > -b - std::sqrt(1 - from_wall * from_wall);
            if (!(ahead > 0) || is_gone)
                continue;
            const double step = top / steps;
            sums.chip += std::abs(x) / radius * step;
            sums.edge += step;
            sums.chip_torque += std::abs(x) * step;
            sums.edge_torque += radius * step;
        }
    return sums;
}

// When milling down the azimuth of the model is pi minus that of the machine.
TEST(ForcePattern, OfARightHandCutterHasTheHelixOfItsSide)
{
    for (const BallEngagement& cut :
         {BallEngagement{0, 0, 0.5, 1}, {-0.4, -0.5, 0.4, 1}, {0.3, 0.2, 0.7, 0.8}}) {
        const MillingTool right_hand = tool(2);
        const ForcePattern up{cut, ChipModel::Paper, right_hand};
        const ForcePattern down{cut, ChipModel::Paper, tool(2, -thirty_degrees)};
        double largest_up = 0;
        double largest_down = 0;
        for (int k = 0; k < 60; ++k) {
            const double turn = pi * (k + 0.5) / 60;
            const EdgeSums left = in_the_room(cut, right_hand, 1, turn);
            const EdgeSums right = in_the_room(cut, right_hand, -1, turn);
            EXPECT_NEAR(up.at(turn).chip_torque, left.chip_torque, 3e-4);
            EXPECT_NEAR(up.at(turn).edge, left.edge, 3e-4);
            EXPECT_NEAR(down.at(pi - turn).chip_torque, right.chip_torque, 3e-4);
            EXPECT_NEAR(down.at(pi - turn).chip, right.chip, 3e-4);
            EXPECT_NEAR(down.at(pi - turn).edge_torque, right.edge_torque, 3e-4);
            largest_up = std::max(largest_up, left.chip_torque);
            largest_down = std::max(largest_down, right.chip_torque);
        }
        const double mean = up.mean().chip_torque;
        EXPECT_NEAR(up.peak_factor() / (largest_up / mean), 1, 0.05);
        EXPECT_NEAR(down.peak_factor() / (largest_down / mean), 1, 0.05);
        EXPECT_GT(std::abs(up.peak_factor() / down.peak_factor() - 1), 0.02);
    }
}

// A slot is its own mirror image across the feed.
TEST(ForcePattern, OfASlotHasOnePeakForBothHands)
{
    for (const double lambda : {-0.5, 0.0, 0.4})
        for (const ChipModel chip : {ChipModel::Paper, ChipModel::Exact}) {
            const BallEngagement slot{0, lambda, 0, 1.6, PreviousPass::None};
            const ForcePattern right{slot, chip, tool(2)};
            const ForcePattern left{slot, chip, tool(2, -thirty_degrees)};
            EXPECT_NEAR(right.peak_factor() / left.peak_factor(), 1, 2e-6);
            EXPECT_NEAR(right.at(0.7).chip, left.at(pi - 0.7).chip, 1e-10);
        }
}

// The peak is not below the mean and equals the maximum of dense samples.
TEST(ForcePattern, OfTheSteepestFlutesHasItsPeak)
{
    for (const double helix : {most_helix, -most_helix})
        for (const double depth : {1.0, 2.5}) {
            const ForcePattern pattern{
                {0.2, -0.1, 0.5, depth}, ChipModel::Paper, tool(2, helix)};
            double largest = 0;
            for (int k = 0; k < 20000; ++k)
                largest = std::max(largest, pattern.at(pi * k / 20000).chip_torque);
            const double expected = largest / pattern.mean().chip_torque;
            EXPECT_GE(pattern.peak_factor(), 1);
            EXPECT_NEAR(pattern.peak_factor() / expected, 1, 2e-5);
        }
    EXPECT_THROW((ForcePattern{{0, 0, 0.5, 1}, ChipModel::Paper, tool(2, 1.5)}),
                 DomainError);
}

}  // namespace
}  // namespace endmill
