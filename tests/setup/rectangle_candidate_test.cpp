// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/rectangle_candidate.h"

#include <gtest/gtest.h>

#include "direction_sets.h"

namespace endmill {
namespace {

using test::degree;
using test::turned_to;
using test::up;

RotaryRange degrees(double from, double to)
{
    return {from * degree, to * degree};
}

// The direction R_a(alpha) R_b(beta) z has exactly these angles if |beta| < 90 degrees.
TEST(RectangleCandidate, ReadsTheAnglesThatMadeADirection)
{
    test::Random random{4};
    for (int i = 0; i < 1000; ++i) {
        const double alpha = random.uniform(0, 179.9);
        const double beta = random.uniform(-89.9, 0);
        const RectangleCandidate found =
            rectangle_about(up, Vec3::UnitX(), std::vector{turned_to(alpha, beta)});
        EXPECT_NEAR(found.alpha.to, alpha * degree, 1e-12);
        EXPECT_NEAR(found.beta.from, beta * degree, 1e-12);
        EXPECT_EQ(found.alpha.from, 0);
        EXPECT_EQ(found.beta.to, 0);
    }
}

TEST(RectangleCandidate, HasNoAlphaAlongR1)
{
    const RectangleCandidate found =
        rectangle_about(up, Vec3::UnitX(), std::vector<Vec3>{-Vec3::UnitX()});
    EXPECT_EQ(found.alpha, (RotaryRange{0, 0}));
    EXPECT_NEAR(found.beta.from, -90 * degree, 1e-15);
    EXPECT_EQ(found.area(), 0);
    EXPECT_NEAR(found.sum(), 90 * degree, 1e-15);
}

TEST(RectangleCandidate, FitsAMachineAsItIsOrTurnedButNotMirrored)
{
    const RectangleCandidate found{Vec3::UnitX(), degrees(-10, 40), degrees(-30, 15),
                                   RectangleOrigin::Search};
    EXPECT_TRUE(fits_rigidly(found, {}));
    EXPECT_TRUE(fits_rigidly(found, {degrees(-10, 40), degrees(-30, 15)}));
    EXPECT_TRUE(fits_rigidly(found, {degrees(-45, 15), degrees(-20, 35)}));
    EXPECT_FALSE(fits_rigidly(found, {degrees(-15, 45), degrees(-20, 35)}));
    EXPECT_FALSE(fits_rigidly(found, {degrees(-45, 15), degrees(-35, 20)}));
}

}  // namespace
}  // namespace endmill
