// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/bounded_search.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const std::vector<Interval> box{{-10, 10}, {-10, 10}, {0, 5}};

// Squares of the distances from (3, -2, 1), summed up one by one.
double bowl(std::span<const double> x, double give_up)
{
    const double centre[] = {3, -2, 1};
    double sum = 0;
    for (int k = 0; k < 3 && sum <= give_up; ++k)
        sum += (x[k] - centre[k]) * (x[k] - centre[k]);
    return sum;
}

TEST(BoundedSearch, FindsTheMinimumOfABowl)
{
    const FoundValues found = minimise(box, bowl, {.evaluations = 6000, .enough = -1});
    EXPECT_LT(found.loss, 1e-6);
    EXPECT_NEAR(found.values[0], 3, 1e-3);
    EXPECT_NEAR(found.values[1], -2, 1e-3);
    EXPECT_NEAR(found.values[2], 1, 1e-3);
    EXPECT_EQ(found.evaluations, 6000);
}

TEST(BoundedSearch, FindsWholeNumbersAmongPlateaus)
{
    const auto steps = [](std::span<const double> x, double) {
        return std::abs(std::floor(x[0]) - 4) + std::abs(std::floor(x[1]) + 7) +
               std::abs(std::floor(2 * x[2]) - 3);
    };
    const FoundValues found = minimise(box, steps, {.evaluations = 5000});
    EXPECT_EQ(found.loss, 0);
    EXPECT_LT(found.evaluations, 5000);  // 0 is enough
}

// Whoever gives up early must not change the result: the sum is compared with one limit.
TEST(BoundedSearch, DoesNotDependOnGivingUp)
{
    const auto whole = [](std::span<const double> x, double) {
        return bowl(x, infinity);
    };
    const BoundedSearch search{.evaluations = 2000, .seed = 9};
    const FoundValues early = minimise(box, bowl, search);
    const FoundValues late = minimise(box, whole, search);
    EXPECT_EQ(early.values, late.values);
    EXPECT_EQ(early.loss, late.loss);
}

TEST(BoundedSearch, DependsOnItsSeedOnly)
{
    const BoundedSearch search{.evaluations = 500, .seed = 4};
    EXPECT_EQ(minimise(box, bowl, search).values, minimise(box, bowl, search).values);
    EXPECT_NE(minimise(box, bowl, search).values,
              minimise(box, bowl, {.evaluations = 500, .seed = 5}).values);
}

TEST(BoundedSearch, KeepsAGoodStart)
{
    const FoundValues found =
        minimise(box, bowl, {.evaluations = 30, .start = {{3, -2, 1}}});
    EXPECT_EQ(found.loss, 0);
    EXPECT_EQ(found.values, (std::vector<double>{3, -2, 1}));
}

TEST(BoundedSearch, SurvivesALossThatIsNowhereDefined)
{
    const FoundValues found =
        minimise(box, [](std::span<const double>, double) { return infinity; },
                 {.evaluations = 200});
    EXPECT_EQ(found.loss, infinity);
    EXPECT_EQ(found.values.size(), box.size());
}

TEST(BoundedSearch, RefusesAnEmptyBox)
{
    EXPECT_THROW(minimise({}, bowl, {}), DomainError);
    const std::vector<Interval> turned{{1, 0}};
    EXPECT_THROW(minimise(turned, bowl, {}), DomainError);
}

}  // namespace
}  // namespace endmill
