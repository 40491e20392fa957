// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/rounded_crossing.h"

#include <cmath>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

// Two crossing segments whose directions differ by about `opening`.
void expect_as_by_integers(test::Random& random, double opening)
{
    const auto near = [&](double size) { return random.uniform(-size, size); };
    const SectionPoint middle{near(100), near(100)};
    const SectionPoint along{random.uniform(0.1, 3), near(3)};
    const SectionPoint across{opening * near(1), opening * near(1)};
    const SectionLine p{middle - along, middle + 1.7 * along};
    const SectionLine q{middle - along + across, middle + along - across};
    EXPECT_EQ(rounded_crossing(p, q), exact_crossing(p, q));
    const double s = p.a[0] + random.uniform(0.1, 0.9) * (p.b[0] - p.a[0]);
    EXPECT_EQ(rounded_height(p, s), exact_height(p, s));
}

TEST(RoundedCrossing, AgreesWithIntegerArithmetic)
{
    test::Random random{5};
    for (const double opening : {1.0, 1e-3, 1e-8, 1e-12})
        for (int k = 0; k < 1500; ++k)
            expect_as_by_integers(random, opening);
}

TEST(RoundedCrossing, IsThatWhereThePairsLoseTheirLastBits)
{
    for (const double scale : {1.0, 0x1p-1000, 0x1p-500, 0x1p+990}) {
        const SectionLine p{SectionPoint{-6, 6} * scale, SectionPoint{2, -2} * scale};
        const SectionLine q{SectionPoint{-2, -2} * scale, SectionPoint{6, 6} * scale};
        EXPECT_EQ(rounded_crossing(p, q), SectionPoint(0, 0));
        const SectionLine third{SectionPoint{0, 0}, SectionPoint{3, 1} * scale};
        EXPECT_EQ(rounded_height(third, scale), scale / 3);
    }
}

}  // namespace
}  // namespace endmill
