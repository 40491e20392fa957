// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/accessibility/setup_order.h"

#include <gtest/gtest.h>

#include "direction_sets.h"

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

// Three areas each equal to the next: which count is decided by the least one alone.
TEST(SetupOrder, DoesNotHangOnWhatElseWasOffered)
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

TEST(SetupOrder, LeavesOutWhatIsBeyondItsBound)
{
    Best best{1};
    best.offer('a', {1.1, 1});
    EXPECT_EQ(best.best(), std::nullopt);
    best.offer('b', {1 + 1e-10, 1});
    EXPECT_EQ(best.best(), 'b');
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

TEST(SetupOrder, TellsHowManyAxesMove)
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
