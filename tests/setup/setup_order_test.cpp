// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/setup_order.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "direction_sets.h"
#include "random.h"

namespace endmill {
namespace {

using Best = BestCandidate<char>;

TEST(SetupOrder, TakesTheLeastAreaThenTheLeastSumThenTheFirst)
{
    Best best;
    best.offer('a', {2, 1});
    best.offer('b', {1, 5});
    best.offer('c', {1 + 5e-10, 4});
    best.offer('d', {1 - 5e-10, 4 + 1e-9});
    EXPECT_EQ(best.best(), 'c');
    best.offer('e', {0.9, 9});
    EXPECT_EQ(best.best(), 'e');
    EXPECT_EQ(best.area(), 0.9);
}

// Three areas, each equal to the next one. Only the least area decides which of them are
// equal.
TEST(SetupOrder, DoesNotDependOnOtherCandidates)
{
    const SetupScore chain[] = {{1 + 1.6e-9, 3}, {1 + 0.8e-9, 4}, {1, 5}};
    Best all;
    Best last_two;
    for (int i = 0; i < 3; ++i) {
        all.offer(static_cast<char>('a' + i), chain[i]);
        if (i > 0)
            last_two.offer(static_cast<char>('a' + i), chain[i]);
    }
    EXPECT_EQ(all.best(), 'b');
    EXPECT_EQ(last_two.best(), 'b');
}

TEST(SetupOrder, LeavesOutCandidatesBeyondItsBound)
{
    Best best{1};
    best.offer('a', {1.1, 1});
    EXPECT_EQ(best.best(), std::nullopt);
    best.offer('b', {1 + 1e-10, 1});
    EXPECT_EQ(best.best(), 'b');
}

// Five poses, with areas that equal those of their neighbours but not the least. The
// poses are offered in every order, each with the least area so far as its bound, as
// threads would do. The best is always that of a search without bounds.
TEST(SetupOrder, IsTheSameForBoundsFromPosesInAnyOrder)
{
    struct Offer {
        int name;
        SetupScore score;
    };
    test::Random random{11};
    for (int trial = 0; trial < 2000; ++trial) {
        std::vector<std::vector<Offer>> poses(5);
        for (int k = 0; k < 15; ++k)
            poses[static_cast<std::size_t>(k) / 3].push_back(
                {k,
                 {1 + 4e-10 * std::floor(random.uniform(0, 8)), random.uniform(1, 4)}});
        const auto pick = [](const std::vector<Offer>& offers, double bound) {
            BestCandidate<Offer> best{bound};
            for (const Offer& offer : offers)
                best.offer(offer, offer.score);
            return best.best();
        };
        const auto best_of_all = [&](const std::vector<std::size_t>& order,
                                     bool is_bounded) {
            double bound = std::numeric_limits<double>::infinity();
            std::vector<std::optional<Offer>> picked(poses.size());
            for (const std::size_t pose : order) {
                picked[pose] = pick(poses[pose], bound);
                if (is_bounded && picked[pose])
                    bound = std::min(bound, picked[pose]->score.area);
            }
            std::vector<Offer> offers;
            for (const std::optional<Offer>& offer : picked)
                if (offer)
                    offers.push_back(*offer);
            return pick(offers, std::numeric_limits<double>::infinity())->name;
        };
        std::vector<std::size_t> order{0, 1, 2, 3, 4};
        const int expected = best_of_all(order, false);
        for (int i = 0; i < 10; ++i) {
            std::swap(order[static_cast<std::size_t>(random.uniform(0, 5))], order[0]);
            EXPECT_EQ(best_of_all(order, true), expected);
        }
    }
}

TEST(SetupOrder, ComparesSmallNumbersByDegrees)
{
    const double square = test::degree * test::degree;
    EXPECT_NEAR(equal_area_limit(0), 1e-9 * square, 1e-20);
    EXPECT_NEAR(equal_area_limit(4) - 4, 4e-9, 1e-15);
    EXPECT_NEAR(equal_sum_limit(0), 1e-9 * test::degree, 1e-20);
    EXPECT_NEAR(equal_sum_limit(2) - 2, 2e-9, 1e-15);
}

TEST(SetupOrder, FitsRangesWithAndWithoutTheirSigns)
{
    const RotaryRange limits{-0.5, 1};
    EXPECT_TRUE(is_within({-0.5, 1}, limits));
    EXPECT_TRUE(is_within({-0.5 - 5e-10, 1 + 5e-10}, limits));
    EXPECT_FALSE(is_within({-0.5 - 2e-9, 1}, limits));
    EXPECT_FALSE(is_within({-1, 0.5}, limits));
    EXPECT_TRUE(is_within_unsigned({-1, 0.5}, limits));
    EXPECT_FALSE(is_within_unsigned({-0.6, 0.6}, limits));
    EXPECT_EQ(turned(limits), (RotaryRange{-1, 0.5}));
}

TEST(SetupOrder, CountsTheMovingAxes)
{
    FittedPose fit{};
    fit.phi = {0, 0};
    fit.theta = {0, 0};
    EXPECT_EQ(status_of(fit), SetupStatus::ThreeAxis);
    fit.phi = {-0.2, 0.3};
    EXPECT_EQ(status_of(fit), SetupStatus::FourAxis);
    fit.theta = {0, 0.1};
    EXPECT_EQ(status_of(fit), SetupStatus::Ok);
    EXPECT_NEAR(score_of(fit).sum, 0.6, 1e-15);
}

}  // namespace
}  // namespace endmill
