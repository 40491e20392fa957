// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/cutting_coefficients.h"

#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/process/detail/engaged_region.h"
#include "random.h"
#include "sliced_coefficients.h"

namespace endmill {
namespace {

using std::numbers::pi;
using test::largest_difference;
using test::listed;
using test::sliced_coefficients;

// Engagements as in the benchmark of the coefficients, with the given seed.
BallEngagement random_engagement(test::Random& random)
{
    const double mu = random.uniform(-1.3, 1.3);
    const double lambda = random.uniform(-1.2, 1.2);
    const double pick_feed = random.uniform(0.02, 1.02);
    return {mu, lambda, pick_feed, random.uniform(0.05, 1.55)};
}

BallEngagement slot(double lambda)
{
    return {0, lambda, 0, 1, PreviousPass::None};
}

TEST(EngagedAngle, IsThatAtTheTopOfTheStock)
{
    EXPECT_NEAR(engaged_angle({0, 0, 0.5, 1}), pi / 3, 1e-12);
    EXPECT_NEAR(engaged_angle({0, 0, 0.5, 7}), pi / 3, 1e-12);
    EXPECT_NEAR(engaged_angle({0, 0.3, 0, 2, PreviousPass::None}), pi, 1e-12);
    EXPECT_NEAR(engaged_angle({0, 0.3, 0, 2, PreviousPass::Edge}), pi / 2, 1e-12);
    EXPECT_NEAR(engaged_angle({0, -0.9, 0, 0.1, PreviousPass::None}), 2 * pi, 1e-12);
    EXPECT_EQ(engaged_angle({0, 0, 0.5, 0}), 0);
}

// The angle is that of `engaged_ranges` at the same latitude, which knows no coefficients.
TEST(EngagedCoefficients, HaveTheAngleOfTheRangesAtTheTop)
{
    for (const double depth : {0.05, 0.4, 1.0, 2.0})
        for (const double mu : {-0.7, 0.0, 0.5}) {
            const BallEngagement engagement{mu, 0.2, 0.3, depth};
            double sum = 0;
            for (const AzimuthRange& range :
                 engaged_ranges(engagement, std::acos(std::max(0.0, 1 - depth))))
                sum += range.to - range.from;
            EXPECT_NEAR(engaged_coefficients(engagement).engaged_angle, sum, 1e-12);
        }
    EXPECT_EQ(engaged_coefficients({0, 0.2, 0.3, 0}).engaged_angle, 0);
}

TEST(CuttingCoefficients, OfALevelSlotAreClosed)
{
    const auto found = listed(cutting_coefficients(slot(0)));
    EXPECT_LT(largest_difference(found, {0, 0.25, 0, 1 / pi, 1 / pi, 0.5, 0.25, pi / 8}),
              1e-12);
}

TEST(CuttingCoefficients, OfHalfImmersionAreClosed)
{
    const auto found = listed(cutting_coefficients({0, 0, 0, 1, PreviousPass::Edge}));
    const double f = 1 / (2 * pi);
    EXPECT_LT(largest_difference(found, {f / 2, 0.125, f, f, f, 0.25, 0.125, pi / 16}),
              1e-12);
}

TEST(CuttingCoefficients, OfTheShankAreClosed)
{
    const BallEngagement engagement{0, 0, 0.5, 2};
    EXPECT_LT(largest_difference(
                  listed(shank_coefficients(engagement)),
                  {0.0596831036595, 0.0488752773695, 0.137832223855, 0.0795774715459,
                   0.0795774715459, 1.0 / 6, 0.0795774715459, 1.0 / 6}),
              1e-12);
    const auto exact = listed(shank_coefficients({0, 0.5, 0.5, 2}, ChipModel::Exact));
    EXPECT_NEAR(exact[4], 0.0795774715459 * std::cos(0.5), 1e-12);
    EXPECT_NEAR(exact[5], 1.0 / 6, 1e-12);
    EXPECT_EQ(listed(shank_coefficients({0, 0, 0.5, 1})), (std::array<double, 8>{}));
}

TEST(CuttingCoefficients, OnLevelGroundAreClosed)
{
    for (const double R : {0.05, 0.5, 1.3}) {
        const CuttingCoefficients c = cutting_coefficients({0, 0, R, 1});
        const double d0 = std::asin(R / 2);
        EXPECT_NEAR(
            c.I1, (2 * R * (pi / 2 - d0) + R * R * std::log(std::tan(d0 / 2))) / (4 * pi),
            1e-11);
        const double fourth = (2 * (1 - std::cos(d0)) + R * (pi / 2 - d0)) / (2 * pi);
        EXPECT_NEAR(c.I4, fourth, 1e-11);
        EXPECT_NEAR(c.I5, fourth, 1e-11);
        EXPECT_NEAR(c.I7, (d0 + R / 2 * std::cos(d0)) / (2 * pi), 1e-11);
    }
}

// Closed forms of a slot on a slope, with complete elliptic integrals. Source:
// docs/methods/ball-end-milling.md, section 9, A7.
TEST(CuttingCoefficients, OfASlopingSlotAreClosed)
{
    for (const double lambda : {-1.4, -0.7, -0.1, -1e-4, 1e-4, 0.2, 0.9, 1.5}) {
        const auto found = listed(cutting_coefficients(slot(lambda)));
        const double c = std::cos(lambda);
        const double steep = std::abs(lambda);
        const double fourth = (std::comp_ellint_2(c) -
                               std::pow(std::sin(lambda), 2) * std::comp_ellint_1(c)) /
                              (pi * c);
        const double second =
            ((pi / 2 - steep) * (2 - 1 / (c * c)) + std::tan(steep)) / (2 * pi);
        EXPECT_NEAR(found[0], 0, 1e-10);
        EXPECT_NEAR(found[1], second, 1e-10);
        EXPECT_NEAR(found[2], 0, 1e-10);
        EXPECT_NEAR(found[3], fourth, 1e-10);
        EXPECT_NEAR(found[4], lambda >= 0 ? fourth : 2 / pi - fourth, 1e-10);
        EXPECT_NEAR(found[5], 0.5 - lambda / pi, 1e-10);
        EXPECT_NEAR(found[6], lambda >= 0 ? c / 4 : (2 - c) / 4, 1e-10);
        EXPECT_NEAR(found[7] + cutting_coefficients(slot(-lambda)).I8, pi / 4, 1e-10);
    }
}

// The section of a slot normal to the feed is half a disc, minus (uphill) or plus
// (downhill) half an ellipse.
TEST(CuttingCoefficients, OfTheExactChipGiveTheSectionOfASlot)
{
    for (const double lambda : {-1.2, -0.3, 0.0, 0.5, 1.3}) {
        const double exact = cutting_coefficients(slot(lambda), ChipModel::Exact).I7;
        EXPECT_NEAR(2 * pi * exact, pi / 2 * (1 - std::sin(lambda)), 1e-10);
    }
    const double paper = cutting_coefficients(slot(-0.5)).I7;
    EXPECT_GT(std::abs(2 * pi * paper - pi / 2 * (1 - std::sin(-0.5))), 0.1);
}

TEST(CuttingCoefficients, AreThoseOfTheDataSet)
{
    std::ifstream file{std::string{ENDMILL_SOURCE_DIR} +
                       "/datasets/cutting-coefficients/ball-end-coefficients.csv"};
    std::string line;
    std::getline(file, line);
    int rows = 0;
    while (std::getline(file, line)) {
        std::istringstream cells{line};
        std::vector<std::string> cell(14);
        for (std::string& text : cell)
            std::getline(cells, text, ',');
        const auto number = [&](int k) { return number_from_text(cell[k]).value(); };
        const BallEngagement engagement{
            number(2), number(3), number(4), number(5),
            cell[0] == "pass" ? PreviousPass::Beside : PreviousPass::None};
        const auto found = listed(cutting_coefficients(
            engagement, cell[1] == "paper" ? ChipModel::Paper : ChipModel::Exact));
        for (int k = 0; k < 8; ++k)
            EXPECT_NEAR(found[k], number(6 + k), engagement.lambda == 0 ? 1e-11 : 1e-10)
                << line;
        ++rows;
    }
    EXPECT_EQ(rows, 23);
}

// [ParkMaeng, figure 3]: I1 at a depth of the radius and a pick feed of half of it. The
// values come from integration by slices (docs/methods/ball-end-milling.md, section
// 3.5).
TEST(CuttingCoefficients, DrawTheThirdFigure)
{
    const std::vector<std::vector<double>> table{
        {0.02687505, 0.03502310, 0.02820586, 0.01021159, 0.00064258},
        {0.05286557, 0.05063108, 0.04390174, 0.02735467, 0.00678052},
        {0.07760516, 0.06309636, 0.05643877, 0.04315740, 0.01805300},
        {0.08798736, 0.07171409, 0.06384157, 0.05243942, 0.02656772},
        {0.07844673, 0.06182371, 0.05639904, 0.04851061, 0.02674582},
        {0.05468601, 0.04059222, 0.03546178, 0.03268111, 0.01910969},
        {0.02730300, 0.02031264, 0.01752115, 0.01540552, 0.00895278}};
    for (int row = 0; row < 7; ++row)
        for (int column = 0; column < 5; ++column) {
            const BallEngagement engagement{(-60 + 20 * row) * pi / 180,
                                            (-60 + 30 * column) * pi / 180, 0.5, 1};
            EXPECT_NEAR(cutting_coefficients(engagement).I1, table[row][column], 5.1e-9);
        }
}

TEST(CuttingCoefficients, EqualIntegrationBySlices)
{
    test::Random random{11};
    for (int k = 0; k < 40; ++k) {
        BallEngagement engagement = random_engagement(random);
        engagement.depth_ratio = std::min(1.0, engagement.depth_ratio);
        if (k % 5 == 0)
            engagement.previous = k % 10 == 0 ? PreviousPass::None : PreviousPass::Edge;
        for (const ChipModel chip : {ChipModel::Paper, ChipModel::Exact}) {
            EXPECT_LT(largest_difference(listed(cutting_coefficients(engagement, chip)),
                                         sliced_coefficients(engagement, chip)),
                      1e-10)
                << engagement.mu << ' ' << engagement.lambda << ' '
                << engagement.pick_feed_ratio << ' ' << engagement.depth_ratio;
        }
    }
}

// Level moves have the accuracy 1e-11.
TEST(CuttingCoefficients, EqualIntegrationBySlicesOnLevelMoves)
{
    test::Random random{12};
    for (int k = 0; k < 12; ++k) {
        BallEngagement engagement = random_engagement(random);
        engagement.lambda = 0;
        engagement.depth_ratio = std::min(1.0, engagement.depth_ratio);
        EXPECT_LT(largest_difference(listed(cutting_coefficients(engagement)),
                                     sliced_coefficients(engagement, ChipModel::Paper)),
                  1e-11);
    }
}

TEST(CuttingCoefficients, HaveTheRequestedAccuracy)
{
    test::Random random{7};
    for (int k = 0; k < 1500; ++k) {
        const BallEngagement engagement = random_engagement(random);
        for (const ChipModel chip : {ChipModel::Paper, ChipModel::Exact}) {
            const auto best = listed(cutting_coefficients(engagement, chip, 1e-12));
            for (const double accuracy : {1e-3, 1e-6, 1e-10}) {
                EXPECT_LE(
                    largest_difference(
                        listed(cutting_coefficients(engagement, chip, accuracy)), best),
                    accuracy);
            }
        }
    }
}

// I4 has the weight sin(azimuth) and I5 its magnitude, so they are equal if nothing is
// cut behind the axis.
TEST(CuttingCoefficients, FourAndFiveDifferBehindTheAxisOnly)
{
    test::Random random{13};
    for (int k = 0; k < 300; ++k) {
        const BallEngagement engagement = random_engagement(random);
        const CuttingCoefficients c = cutting_coefficients(engagement);
        bool is_behind = false;
        for (int ring = 1; ring < 60; ++ring)
            for (const AzimuthRange& range : engaged_ranges(engagement, ring * pi / 120))
                is_behind |= range.from < -1e-3 || range.to > pi + 1e-3;
        if (is_behind) {
            EXPECT_LT(c.I4, c.I5);
        } else {
            EXPECT_NEAR(c.I4, c.I5, 1e-4);
        }
        if (engagement.lambda >= 0) {
            EXPECT_NEAR(c.I4, c.I5, 2e-10);
        }
    }
}

// Steps of 1e-9 in every parameter, across configurations in which borders appear, vanish
// and touch.
TEST(CuttingCoefficients, DoNotJumpWhereTheRegionChangesItsShape)
{
    const double touching = 2 * std::cos(0.7);
    const std::vector<BallEngagement> changes{{0.4, 0, 0.5, 1},
                                              {0, 0, 0.5, 1},
                                              {0.7, 0.3, touching, 1},
                                              {-0.7, -0.3, touching, 1},
                                              {0.2, -0.3, 2, 0.8},
                                              {0, 0.5, 1, 1},
                                              {0, -0.5, 1, 1},
                                              {0, 0.5, 0.4, 1 - std::cos(0.5)},
                                              {pi / 3, -0.2, 1, 0.5},
                                              {-pi / 3, -0.2, 1, 1},
                                              {0.3, 0, 1 / std::cos(0.3), 1}};
    constexpr double step = 1e-9;
    // Areas near a new region grow like square roots.
    constexpr double change = 1e-4;
    for (const BallEngagement& at : changes) {
        const auto here = listed(cutting_coefficients(at));
        for (const double side : {-step, step}) {
            for (const BallEngagement& near :
                 {BallEngagement{at.mu + side, at.lambda, at.pick_feed_ratio,
                                 at.depth_ratio},
                  BallEngagement{at.mu, at.lambda + side, at.pick_feed_ratio,
                                 at.depth_ratio},
                  BallEngagement{at.mu, at.lambda, at.pick_feed_ratio + side,
                                 at.depth_ratio},
                  BallEngagement{at.mu, at.lambda, at.pick_feed_ratio,
                                 at.depth_ratio + side}})
                EXPECT_LT(largest_difference(listed(cutting_coefficients(near)), here),
                          change)
                    << at.mu << ' ' << at.lambda;
        }
    }
}

TEST(CuttingCoefficients, InAirAreZero)
{
    const std::array<double, 8> nothing{};
    EXPECT_EQ(listed(cutting_coefficients({0.1, 0.2, 0.5, 0})), nothing);
    EXPECT_EQ(listed(cutting_coefficients({0.1, 0.2, 0.5, -3})), nothing);
    EXPECT_EQ(listed(cutting_coefficients({0.1, 0.2, 0, 1})), nothing);
    EXPECT_EQ(listed(cutting_coefficients({0.1, 0.2, 0, 0, PreviousPass::None})),
              nothing);
    EXPECT_LT(cutting_coefficients({0.1, -0.2, 1e-12, 1e-12}).I6, 1e-9);
}

TEST(CuttingCoefficients, StayFiniteAtTheEndsOfTheirDomain)
{
    for (const double mu : {-1.57079, -1e-300, 0.0, 1.57079})
        for (const double lambda : {-1.57079, -1e-12, 0.0, 1e-300, 1.57079})
            for (const double feed : {1e-300, 1e-12, 1.0, 2.0, 2.5, 1e9, 1e300})
                for (const double depth : {1e-300, 1e-9, 0.5, 1.0, 1e9})
                    for (const ChipModel chip : {ChipModel::Paper, ChipModel::Exact}) {
                        for (const double c : listed(
                                 cutting_coefficients({mu, lambda, feed, depth}, chip)))
                            EXPECT_TRUE(std::isfinite(c))
                                << mu << ' ' << lambda << ' ' << feed << ' ' << depth;
                    }
}

TEST(CuttingCoefficients, RefuseUnsoundEngagements)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const BallEngagement& bad :
         {BallEngagement{pi / 2, 0, 0.5, 1}, BallEngagement{0, -pi / 2, 0.5, 1},
          BallEngagement{nan, 0, 0.5, 1}, BallEngagement{0, nan, 0.5, 1},
          BallEngagement{0, 0, -0.1, 1}, BallEngagement{0, 0, infinity, 1},
          BallEngagement{0, 0, 0.5, infinity}, BallEngagement{0, 0, 0.5, nan}})
        EXPECT_THROW(cutting_coefficients(bad), DomainError);
    EXPECT_THROW(cutting_coefficients({0, 0, 0.5, 1}, ChipModel::Paper, 1e-13),
                 DomainError);
    EXPECT_THROW(cutting_coefficients({0, 0, 0.5, 1}, ChipModel::Paper, nan),
                 DomainError);
}

TEST(CuttingCoefficients, OfManyEqualThoseOfEach)
{
    test::Random random{14};
    std::vector<BallEngagement> engagements;
    engagements.reserve(200);
    for (int k = 0; k < 200; ++k)
        engagements.push_back(random_engagement(random));
    const auto all = cutting_coefficients(engagements, ChipModel::Exact, 1e-6);
    for (std::size_t k = 0; k < all.size(); ++k)
        EXPECT_EQ(listed(all[k]),
                  listed(cutting_coefficients(engagements[k], ChipModel::Exact, 1e-6)));
}

}  // namespace
}  // namespace endmill
