// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/quartic_roots.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

Quartic with_roots(const std::vector<double>& roots)
{
    Quartic c{1, 0, 0, 0, 0};
    for (const double root : roots)
        for (int k = 4; k >= 0; --k)
            c[k] = (k > 0 ? c[k - 1] : 0) - root * c[k];
    return c;
}

double distance_to(const RootsAndExtrema& found, double place)
{
    double least = 10;
    for (int k = 0; k < found.count; ++k)
        least = std::min(least, std::abs(found.at[k] - place));
    return least;
}

TEST(RootsAndExtrema, FindTheGivenRoots)
{
    test::Random random{3};
    for (int n = 0; n < 2000; ++n) {
        std::vector<double> roots;
        for (int k = 0; k < 4; ++k)
            roots.push_back(-0.95 + 0.5 * k + random.uniform(0, 0.3));
        const RootsAndExtrema found = roots_and_extrema(with_roots(roots), -1, 1);
        for (const double root : roots) {
            if (root < 1) {
                EXPECT_LT(distance_to(found, root), 1e-12);
            }
        }
        EXPECT_TRUE(std::is_sorted(found.at.begin(), found.at.begin() + found.count));
    }
}

TEST(RootsAndExtrema, OfLowerDegreesAreFound)
{
    EXPECT_LT(distance_to(roots_and_extrema(with_roots({0.1, -0.7, 0.5}), -1, 1), 0.1),
              1e-12);
    EXPECT_LT(distance_to(roots_and_extrema(with_roots({0.1, -0.7}), -1, 1), -0.7),
              1e-12);
    EXPECT_LT(distance_to(roots_and_extrema({-0.25, 1, 0, 0, 0}, -1, 1), 0.25), 1e-12);
    EXPECT_EQ(roots_and_extrema({1, 0, 0, 0, 0}, -1, 1).count, 0);
    EXPECT_EQ(roots_and_extrema({}, -1, 1).count, 0);
}

// Rounding may remove or split a double root; the root of the derivative remains.
TEST(RootsAndExtrema, HaveDoubleRoots)
{
    test::Random random{4};
    for (int n = 0; n < 2000; ++n) {
        const double twice = random.uniform(-0.9, 0.9);
        const double other = random.uniform(-0.9, 0.9);
        const Quartic both = with_roots({twice, twice, other, other});
        EXPECT_LT(distance_to(roots_and_extrema(both, -1, 1), twice), 1e-6);
    }
}

TEST(RootsAndExtrema, OfNoRealRootsPartMonotonicStretches)
{
    // (u^2 - 1/4)^2 + 1 has minima at -1/2 and 1/2 and a maximum at 0.
    const RootsAndExtrema found = roots_and_extrema({1.0625, 0, -0.5, 0, 1}, -1, 1);
    ASSERT_EQ(found.count, 3);
    EXPECT_NEAR(found.at[0], -0.5, 1e-12);
    EXPECT_NEAR(found.at[1], 0, 1e-12);
    EXPECT_NEAR(found.at[2], 0.5, 1e-12);
}

}  // namespace
}  // namespace endmill
